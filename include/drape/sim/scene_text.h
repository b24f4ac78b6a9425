#pragma once

#include <string>

#include "drape/sim/settings.h"

namespace drape {

/// The scene file of some settings: all that differ from their defaults, and the sizes of the cloths.
/// `parse_scene` reads the same settings back.
std::string scene_text(const Settings& settings);

}  // namespace drape
