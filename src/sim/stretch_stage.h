#pragma once

#include <span>

#include "drape/sim/cloth.h"
#include "drape/sim/step_report.h"

namespace drape {

/// The stage of a substep after the integrator: shortens structural springs to the limit of each cloth. Its time counts
/// as the integrator's.
/// @pre every state is finite
/// @par Cost as `drape::limit_stretch` of the model
void limit_stretch(std::span<Cloth> cloths, StepReport& report);

/// Reports the largest excess that shortening and contact have left at the end of a step of length dt [s].
/// @par Cost one pass over two springs a particle; nothing without a limit
void measure_stretch(std::span<const Cloth> cloths, double dt, StepReport& report);

}  // namespace drape
