#pragma once

#include <array>

#include "drape/contact/closest_point.h"

namespace drape {

/// Position or velocity of one particle.
inline Vec3 position(const Points& x, int particle) { return x.row(particle).transpose(); }

/// The point of a triangle of the cloth that is closest to a point.
inline ClosestPoint closest_point(const Points& x, const std::array<int, 3>& corners, const Vec3& p) {
    return closest_point_on_triangle(p, position(x, corners[0]), position(x, corners[1]), position(x, corners[2]));
}

}  // namespace drape
