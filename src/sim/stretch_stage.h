#pragma once

#include <span>

#include "drape/sim/cloth.h"
#include "drape/sim/step_report.h"

namespace drape {

/// The stage of a substep after the integrator: shortens structural springs to the limit of each cloth, and reports the
/// largest excess that is left. Its time counts as the integrator's.
/// @pre every state is finite
/// @par Cost as `drape::limit_stretch` of the model
void limit_stretch(std::span<Cloth> cloths, StepReport& report);

}  // namespace drape
