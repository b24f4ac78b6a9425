#pragma once

#include "drape/bounds/bounding_sphere.h"
#include "patch_kernels.h"

namespace drape {

/// About a centre through the farthest particle, so that every particle is inside with rounding.
/// @par Cost O(particles), one pass
inline BoundingSphere measured_sphere(const Patch& patch, const Vec3& centre) {
    Real square = 0;
    kernels::raise_to_farthest(patch, &centre, 1, &square);
    return {centre, BoundingSphere::radius_of(square)};
}

}  // namespace drape
