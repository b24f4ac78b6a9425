#pragma once

#include "drape/base/real.h"
#include "drape/model/grid.h"

namespace drape {

/// The places of a cloth at which another grid's particles lie, bilinearly between the particles that there are.
/// @param x of `from`, n x 3 [m]
/// @return of `to`, n x 3 [m]
Points resampled(const Points& x, const Grid& from, const Grid& to);

}  // namespace drape
