#pragma once

#include "drape/bounds/obb.h"

/// Smallest and largest coordinates of a patch's particles along several directions, vectorised as in
/// `patch_kernels.h`.
namespace drape::kernels {

/// Along the directions of a k-DOP, `dop_numbers<K>`, by sums alone.
/// @param low, high receive K / 2 each
template <int K>
void dop_extents(const Patch& patch, Real* low, Real* high);

/// Along three directions, measured from a point.
/// @param low, high receive 3 each
void extents_along(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high);

}  // namespace drape::kernels
