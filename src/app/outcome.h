#pragma once

#include <string>

#include "drape/sim/simulation.h"

namespace drape {

/// What a command that was carried out has set, for the user: "integrator: rk4", with the reason where that shows
/// nothing or is no good in the present scene. Empty for commands whose outcome is seen.
std::string outcome_of(const Command& command, const Simulation& simulation);

}  // namespace drape
