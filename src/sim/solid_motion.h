#pragma once

#include <vector>

#include "drape/contact/solid.h"
#include "drape/scene/settings.h"

namespace drape {

/// The solids that the settings describe, with their meshes read from files.
/// @throws InputError that names file and line
std::vector<Solid> make_solids(const std::vector<SolidSettings>& settings);

/// Puts solids where they are at a time [s], at rest.
void put_solids(const std::vector<SolidSettings>& settings, double time, std::vector<Solid>& solids);

/// Moves a solid over one substep, from `time` to `time + h` [s].
void move_solid(const SolidSettings& settings, Real time, Real h, Solid& solid);

}  // namespace drape
