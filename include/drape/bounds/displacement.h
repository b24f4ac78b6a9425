#pragma once

#include "drape/bounds/bounding_volume.h"

namespace drape {

/// The largest distance of a particle from where it was before, max |x_p - before_p|, grown by the rounding [m].
/// @par Cost O(particles), one pass over both
Real largest_displacement(const Points& x, const Points& before);

/// The same of the particles of a patch.
/// @param before as `copy_points` had them
Real largest_displacement(const Patch& patch, const Points& before);

/// Copies the positions of a patch's particles, row by row.
void copy_points(const Patch& patch, Points& to);

}  // namespace drape
