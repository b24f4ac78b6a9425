#pragma once

#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// A pass that finds the particle farthest from a point.
using FindFarthest = Vec3 (*)(const Patch&, const Vec3& from);

/// The centre of the smallest sphere about the particles of a patch, to the rounding.
///
/// A sphere is held with its support, at most four particles on it that it is the smallest sphere about. The particle
/// that is farthest from its centre, if it stands out, is on the smallest sphere about itself and the support, which is
/// solved next; its radius can only grow, and ends when nothing stands out. @cite welzl1991 @cite gaertner1999
/// @par Cost O(particles) a pass; about ten passes; no heap
Vec3 smallest_sphere_centre(const Patch& patch, FindFarthest find_farthest);

}  // namespace drape
