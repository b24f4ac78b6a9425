#pragma once

#include <array>

#include "drape/base/real.h"

namespace drape {

/// The closest point of a triangle, or of the segment or point that it has degenerated to.
struct ClosestPoint {
    Vec3 point;
    std::array<Real, 3> barycentric;
};

/// The point of triangle a, b, c that is closest to p: its distance is exact but for the last digits of the
/// largest coordinate, however thin the triangle. @cite ericson2004
/// @par Cost constant, no square root
ClosestPoint closest_point_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Position or velocity of one particle.
inline Vec3 position(const Points& x, int particle) { return x.row(particle).transpose(); }

/// The point of a triangle of a cloth that is closest to p.
/// @param x n x 3 [m]
inline ClosestPoint closest_point(const Points& x, const std::array<int, 3>& corners, const Vec3& p) {
    return closest_point_on_triangle(p, position(x, corners[0]), position(x, corners[1]), position(x, corners[2]));
}

/// The points of two segments that are closest to each other.
struct ClosestOfSegments {
    Real first = 0, second = 0;  ///< weight of each segment's end, from 0 at its start to 1
    Vec3 offset = Vec3::Zero();  ///< from the second's point to the first's [m]
};

/// Of the segments from a to b and from c to d. Where they are parallel and side by side, one of the points is an end.
/// @cite ericson2004
/// @par Cost constant
ClosestOfSegments closest_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace drape
