#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "drape/contact/closest_point.h"
#include "drape/contact/contact.h"

namespace drape {

/// Position or velocity of one particle.
inline Vec3 position(const Points& x, int particle) { return x.row(particle).transpose(); }

/// The point of a triangle of the cloth that is closest to a point.
inline ClosestPoint closest_point(const Points& x, const std::array<int, 3>& corners, const Vec3& p) {
    return closest_point_on_triangle(p, position(x, corners[0]), position(x, corners[1]), position(x, corners[2]));
}

/// The contact point's mean of what its corners have: velocities, or positions.
inline Vec3 at_point(const Contact& contact, const Points& v) {
    return contact.barycentric[0] * position(v, contact.corners[0]) +
           contact.barycentric[1] * position(v, contact.corners[1]) +
           contact.barycentric[2] * position(v, contact.corners[2]);
}

/// Fills point, barycentric, normal and depth of a contact from the present positions of its corners; that of a node
/// stays at its point of the triangle. A triangle through the very centre is pushed along its own normal.
/// @return false, with depth 0 and the rest as it was, if the triangle, or the node's sphere, does not touch the ball
inline bool locate(const Points& x, const Ball& ball, Real thickness, Contact& contact) {
    const ClosestPoint closest = contact.of_node ? ClosestPoint{at_point(contact, x), contact.barycentric}
                                                 : closest_point(x, contact.corners, ball.centre);
    const Vec3 offset = closest.point + contact.offset - ball.centre;
    const Real square = offset.squaredNorm(), reach = ball.radius + thickness + contact.radius;
    contact.depth = 0;
    if (!(square < reach * reach && reach > 0)) return false;
    const Real distance = std::sqrt(square);
    contact.depth = reach - distance;
    contact.barycentric = closest.barycentric;
    contact.point = closest.point;
    if (distance > 0) {
        contact.normal = offset / distance;
    } else {
        const auto [a, b, c] = contact.corners;
        const Vec3 across = (position(x, b) - position(x, a)).cross(position(x, c) - position(x, a));
        contact.normal = across.squaredNorm() > 0 ? across.normalized() : Vec3(0, 1, 0);
    }
    return true;
}

}  // namespace drape
