#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "drape/contact/closest_point.h"
#include "drape/contact/contact.h"

namespace drape {

/// Position or velocity of one particle.
inline Vec3 position(const Points& x, int particle) { return x.row(particle).transpose(); }

/// The point of a triangle of the cloth that is closest to a point.
inline ClosestPoint closest_point(const Grid& grid, const Points& x, int triangle, const Vec3& p) {
    const auto [a, b, c] = grid.triangle_corners(triangle);
    return closest_point_on_triangle(p, position(x, a), position(x, b), position(x, c));
}

/// Fills point, barycentric, normal and depth of a contact from the present positions. A triangle through the very
/// centre is pushed along its own normal.
inline void locate(const Grid& grid, const Points& x, const Ball& ball, Real thickness, Contact& contact) {
    const ClosestPoint closest = closest_point(grid, x, contact.triangle, ball.centre);
    const Vec3 offset = closest.point - ball.centre;
    const Real square = offset.squaredNorm(), reach = ball.radius + thickness;
    contact.depth = square < reach * reach ? reach - std::sqrt(square) : Real(0);
    contact.barycentric = closest.barycentric;
    contact.point = closest.point;
    if (square > 0) {
        contact.normal = offset / std::sqrt(square);
    } else {
        const auto [a, b, c] = grid.triangle_corners(contact.triangle);
        const Vec3 across = (position(x, b) - position(x, a)).cross(position(x, c) - position(x, a));
        contact.normal = across.squaredNorm() > 0 ? across.normalized() : Vec3(0, 1, 0);
    }
}

}  // namespace drape
