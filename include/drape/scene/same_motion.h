#pragma once

#include "drape/scene/settings.h"

namespace drape {

/// True if cloths and balls move alike under both.
bool same_motion(const Settings& a, const Settings& b);

/// True if the cloths start in the same positions with the same particles, so that a state can be kept.
bool same_start(const Settings& a, const Settings& b);

/// True if the integrator that was made for one will do for the other. Only the methods with a limit share their work
/// among threads; the others keep what they remember.
bool same_integrator(const SolverSettings& a, const SolverSettings& b);

/// True if the longest stable step and the number of substeps are the same.
bool same_step_plan(const Settings& a, const Settings& b);

}  // namespace drape
