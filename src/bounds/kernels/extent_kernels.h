#pragma once

#include "drape/bounds/obb.h"

/// Smallest and largest coordinates of a patch's particles along several directions, vectorised as in
/// `patch_kernels.h`.
namespace drape::kernels {

/// Along the directions of a k-DOP, `dop_numbers<2 * slabs>`, by sums alone.
/// @param low, high receive `slabs` each
void dop_extents(const Patch& patch, int slabs, Real* low, Real* high);

/// Along three directions, measured from a point.
/// @param low, high receive 3 each
void extents_along(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high);

}  // namespace drape::kernels
