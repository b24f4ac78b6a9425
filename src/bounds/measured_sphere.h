#pragma once

#include <cmath>
#include <limits>

#include "drape/bounds/bounding_sphere.h"
#include "patch_kernels.h"

namespace drape {

/// Makes up for the rounding of a distance and of its use.
inline constexpr Real rounded_up = 1 + 8 * std::numeric_limits<Real>::epsilon();

/// About a centre through the farthest particle, so that every particle is inside with rounding.
/// @par Cost O(particles), one pass
inline BoundingSphere measured_sphere(const Patch& patch, const Vec3& centre) {
    Real square = 0;
    kernels::raise_to_farthest(patch, &centre, 1, &square);
    return {centre, std::sqrt(square) * rounded_up};
}

}  // namespace drape
