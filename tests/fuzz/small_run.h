#pragma once

#include <optional>

#include "drape/sim/simulation.h"

namespace drape::fuzz {

/// Settings that were accepted, with the sizes cut down on which nothing but time depends.
/// @return nothing if the cloths are too large for a fuzzer
std::optional<Settings> made_small(Settings settings);

/// A few steps of a simulation; every position and velocity must be finite after each, whatever the status.
void step_a_little(Simulation& simulation);

/// Whether both hold the same value in every row of the table of settings.
bool same_settings(const Settings& one, const Settings& other);

}  // namespace drape::fuzz
