#pragma once

#include "drape/integrate/integrator.h"

namespace drape {

/// The longest step with which small waves on the flat cloth do not grow, whatever their length and direction. An
/// estimate for any other shape: folds and stretched springs shift the limit by some percent.
/// @return step [s]; infinite for a cloth without springs
/// @par Cost some milliseconds, whatever the grid
Real estimated_stable_step(const ClothModel& model, IntegratorKind kind);

}  // namespace drape
