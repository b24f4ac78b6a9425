#pragma once

#include "drape/base/real.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// An error at the start of a motion, as root mean square over the free particles [m]: small against any motion, large
/// against rounding.
constexpr Real small_error = sizeof(Real) == sizeof(double) ? Real(1e-9) : Real(1e-4);

/// An error that grows more than this on the way to a horizon makes positions there a matter of luck.
constexpr double most_growth = 50;

/// A state with that error in every free coordinate, the same each time: symmetry would hide what grows.
ClothState disturbed(const ClothModel& model, ClothState state);

/// Root mean square distance of the particles, of the cloth's side.
double position_error(const Points& x, const Points& exact, Real side);

}  // namespace drape
