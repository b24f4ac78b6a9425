#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "drape/contact/closest_point.h"
#include "drape/contact/response.h"

namespace drape {

/// Depth that is left at most [m]: a resting contact then lasts from step to step instead of flickering.
inline constexpr Real most_slop = Real(3e-5);

/// The depth that is left in a ball [m].
inline Real slop_in(const Ball& ball) {
    constexpr Real of_radius = Real(1e-4);
    return std::min(of_radius * ball.radius, most_slop);
}

/// The least cosine between the normal at a substep's end and that at which two things met, for both to be of one side.
inline constexpr Real same_side = Real(0.5);

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

/// From the centre of a ball to a point at some distance; along the triangle's own normal where that is the centre.
inline Vec3 normal_of(const Points& x, const std::array<int, 3>& corners, const Vec3& offset, Real distance) {
    if (distance > 0) return offset / distance;
    const auto [a, b, c] = corners;
    const Vec3 across = (position(x, b) - position(x, a)).cross(position(x, c) - position(x, a));
    return across.squaredNorm() > 0 ? Vec3(across.normalized()) : Vec3(0, 1, 0);
}

/// Depth and normal of a contact whose point is at an offset from the centre of a ball.
/// @param square of the offset's length
/// @param radii of both, thickness counted
inline void measure(const Points& x, Real radii, const Vec3& offset, Real square, Contact& contact) {
    const Real distance = std::sqrt(square);
    contact.depth = radii - distance;
    contact.normal = normal_of(x, contact.corners, offset, distance);
}

/// The contact's point q against a ball: the normal n = (q - c) / |q - c| and the depth r + thickness - |q - c|.
/// @return false, with depth 0 and the normal as it was, if it does not touch
inline bool touch(const Points& x, const Ball& ball, Real thickness, Contact& contact) {
    const Vec3 offset = contact.point + contact.offset - ball.centre;
    const Real square = offset.squaredNorm(), radii = ball.radius + thickness + contact.radius;
    contact.depth = 0;
    if (!(square < radii * radii && radii > 0)) return false;
    measure(x, radii, offset, square, contact);
    return true;
}

/// Ball against triangle: from the present positions of a contact's corners, its closest point, normal and depth. A
/// particle and the contact of a node stay where they are in the triangle.
/// @return false, with depth 0, if the triangle, or the node's sphere, does not touch the ball
inline bool locate(const Points& x, const Ball& ball, Real thickness, Contact& contact) {
    if (contact.of_node || contact.of_particle) {
        contact.point = at_point(contact, x);
    } else {
        const ClosestPoint closest = closest_point(x, contact.corners, ball.centre);
        contact.barycentric = closest.barycentric;
        contact.point = closest.point;
    }
    return touch(x, ball, thickness, contact);
}

/// The depth of a contact's point in its ball: from the surface, or, of an impact, behind the plane at which it met it.
inline Real depth_in(const Ball& ball, Real thickness, const Contact& contact) {
    const Vec3 offset = contact.point + contact.offset - ball.centre;
    const Real distance = contact.of_impact ? offset.dot(contact.normal) : offset.norm();
    return ball.radius + thickness + contact.radius - distance;
}

/// The depth of a contact's point where it and its second body are now; less than zero where they have parted.
inline Real depth_now(const ResponseParameters& parameters, std::span<const Ball> balls, const Contact& contact) {
    if (contact.ball == the_ground) return parameters.ground.height + parameters.thickness - contact.point.y();
    if (is_solid(contact.ball)) {
        return contact.plane.height + parameters.thickness - contact.normal.dot(contact.point);
    }
    return depth_in(balls[static_cast<std::size_t>(contact.ball)], parameters.thickness, contact);
}

/// A contact with the ground, from the present positions of its corners.
/// @return false, with depth 0, if it does not touch
inline bool locate_above(const Points& x, Real height, Real thickness, Contact& contact) {
    contact.point = at_point(contact, x);
    contact.normal = Vec3(0, 1, 0);
    contact.depth = std::max(height + thickness - contact.point.y(), Real(0));
    return contact.depth > 0;
}

/// Where a point that moves evenly first comes towards the origin within a radius: on the sphere, or where it begins.
/// @param from, to at both ends of the substep [m]
inline std::optional<Vec3> first_meeting(const Vec3& from, const Vec3& to, Real radius) {
    const Real outside = from.squaredNorm() - radius * radius;
    const Vec3 displacement = to - from;
    const Real approach = -from.dot(displacement);
    const Real square = approach * approach - displacement.squaredNorm() * outside;
    if (!(approach > 0 && square >= 0)) return std::nullopt;
    const Real time = std::max(outside, Real(0)) / (approach + std::sqrt(square));
    if (time > 1 && to.squaredNorm() > radius * radius) return std::nullopt;
    return from + std::min(time, Real(1)) * displacement;
}

/// Ball against ball, or against the ground, or against the surface of a solid next to it.
/// @return false, with depth 0, if they do not touch
inline bool locate(std::span<const Ball> balls, const Ground& ground, BallContact& contact) {
    const Ball& first = balls[static_cast<std::size_t>(contact.first)];
    if (is_solid(contact.ball)) {
        contact.depth = std::max(contact.plane.height + first.radius - contact.normal.dot(first.centre), Real(0));
        return contact.depth > 0;
    }
    Real distance = first.centre.y() - ground.height, radii = first.radius;
    if (!contact.of_impact) contact.normal = Vec3(0, 1, 0);
    if (contact.ball != the_ground) {
        const Ball& second = balls[static_cast<std::size_t>(contact.ball)];
        const Vec3 offset = first.centre - second.centre;
        radii += second.radius;
        distance = contact.of_impact ? offset.dot(contact.normal) : offset.norm();
        if (!contact.of_impact && distance > 0) contact.normal = offset / distance;
    }
    contact.depth = std::max(radii - distance, Real(0));
    return contact.depth > 0;
}

}  // namespace drape
