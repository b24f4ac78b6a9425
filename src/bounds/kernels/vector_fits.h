#pragma once

#include "drape/bounds/bounding_volume.h"

/// The fits whose passes over the particles are vector kernels. Each gives what the plain fit of the same name gives,
/// to rounding.
namespace drape::kernels {

BoundingSphere fit_centroid_sphere(const Patch& patch);
BoundingSphere fit_box_sphere(const Patch& patch);
BoundingSphere fit_ritter_sphere(const Patch& patch);

/// @tparam lines 3, 7 or 13
template <int lines>
BoundingSphere fit_epos_sphere(const Patch& patch);

BoundingSphere fit_smallest_sphere(const Patch& patch);

/// Of a volume that has one fit: `Aabb`, `KDop<K>` or `Obb`.
template <BoundingVolume Volume>
Volume fit(const Patch& patch);

}  // namespace drape::kernels
