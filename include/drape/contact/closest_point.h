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

}  // namespace drape
