#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "drape/contact/closest_point.h"
#include "drape/contact/response.h"
#include "tuning.h"

namespace drape {

/// The depth that is left in a ball [m].
inline Real slop_in(const Ball& ball) { return std::min(slop_of_radius * ball.radius, max_slop); }

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

/// The depth of a contact's point in its ball, behind its plane.
inline Real depth_in(const Ball& ball, Real thickness, const Contact& contact) {
    const Vec3 offset = contact.point + contact.offset - ball.centre;
    return ball.radius + thickness + contact.radius - offset.dot(contact.normal);
}

/// Moves a contact to the point of its triangle that is closest to the ball now, and its plane with it, if that is on
/// the side where they met. A particle, and the contact of a node, stay where they are in the triangle.
inline void find_closest(const Points& x, const Ball& ball, Real thickness, Contact& contact) {
    ClosestPoint at{at_point(contact, x), contact.barycentric};
    if (!contact.of_node && !contact.of_particle) at = closest_point(x, contact.corners, ball.centre);
    const Vec3 offset = at.point + contact.offset - ball.centre;
    const Real distance = offset.norm();
    if (offset.dot(contact.normal) > same_side * distance) {
        contact.barycentric = at.barycentric;
        contact.normal = offset / distance;
    }
    contact.point = at_point(contact, x);
    contact.depth = depth_in(ball, thickness, contact);
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

/// The depth of two balls where they are now, or of a ball and a plane; less than zero where they have parted.
inline Real depth_now(std::span<const Ball> balls, const Ground& ground, const BallContact& contact) {
    const Ball& first = balls[static_cast<std::size_t>(contact.first)];
    if (contact.ball == the_ground) return first.radius + ground.height - first.centre.y();
    if (is_solid(contact.ball)) return first.radius + contact.plane.height - contact.normal.dot(first.centre);
    const Ball& second = balls[static_cast<std::size_t>(contact.ball)];
    return first.radius + second.radius - (first.centre - second.centre).dot(contact.normal);
}

}  // namespace drape
