#pragma once

#include "drape/sim/settings.h"

namespace drape {

/// The step at which the full model is computed [s]. Contact makes every method one of first order, so it is short.
constexpr double close_step = 1e-4;

/// The scene with all that its model could have: the particles, bend springs and drag of `needs.full`.
/// @throws InputError if the scene has several cloths, or `needs.full.particles` is no grid
Settings full_model(const Settings& scene);

/// A scene, computed so closely that only its model is left to err: by Dormand-Prince between contacts, which are those
/// of each step, and looked for without a limit.
/// @param dt [s]
Settings computed_closely(Settings scene, double dt);

}  // namespace drape
