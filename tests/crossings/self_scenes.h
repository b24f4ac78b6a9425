#pragma once

#include <string>

#include "drape/scene/settings.h"

namespace drape::crossings {

/// A shipped scene of self contact with grids of another size: pinned rows stay where they are, and mass, drag and size
/// of the cloth what they are.
/// @param side particles along each side; 0: as the scene has them
Settings scene_of_side(const std::string& scene, int side);

/// With another method, at a step that is stable, or at 1/240 s where every step is.
/// @return false if no step is
bool use_method(Settings& settings, IntegratorKind integrator);

}  // namespace drape::crossings
