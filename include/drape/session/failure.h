#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drape/sim/simulation.h"

namespace drape {

/// Writes what a run that has diverged can be studied by: a scene that starts from its last good state, so that its
/// first step fails as this one did; where it was divided into substeps, one of as many steps does. What a hand holds
/// is pinned in it. BDF2 starts there without the state before, and may fail a step later.
/// @param folder receives `unstable.toml` and the state beside it, with a number where these exist: nothing is
/// replaced, and the same failure is written once; empty: the current one
/// @return the scene's file
/// @throws RunError if it cannot be written
/// @pre the simulation has diverged
std::filesystem::path write_failure(const Simulation& simulation, const std::filesystem::path& folder);

/// The same for a message: the step's length if that is the cause, and "unstable.toml starts from the last good state",
/// or why there is no such file.
std::string tell_failure(const Simulation& simulation, const std::filesystem::path& folder);

/// What a picture says of a simulation for as long as it is so: why it ended and what helps, else a warning about its
/// step; nothing where all is well.
/// @param failure what `tell_failure` said of it; empty: nothing, and no file was written
std::vector<std::string> state_notices(const Simulation& simulation, const std::string& failure);

}  // namespace drape
