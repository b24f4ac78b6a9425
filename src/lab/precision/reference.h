#pragma once

#include <span>

#include "lab/measure/disturbed_start.h"
#include "lab/measure/state_error.h"
#include "precision_scene.h"

namespace drape {

/// What is taken for the truth at the horizon of a scene, and what that is worth.
struct Reference {
    ClothState state;
    double growth = 0;  ///< of `small_error`, on the way to the horizon
    Measure measure = Measure::Position;
    double error = 0;  ///< its own, in that measure: what the last rung of its ladder has changed
};

/// The last of ever closer solutions. Without a ball: Dormand-Prince, each rung with a tenth of the tolerance. With
/// one, where the step decides when an impact is noticed: velocity Verlet, each rung with half the step; so short that
/// its own error is far below that of the impacts.
/// @par Cost seconds
Reference find_reference(const PrecisionScene& scene);

/// The same of chosen tolerances, for a scene without a ball.
/// @param tolerances at least 2, falling
Reference find_reference(const PrecisionScene& scene, std::span<const Real> tolerances);

/// A reference must be this much better than the best point that is compared with it.
constexpr double least_margin = 100;

/// Outer steps of Dormand-Prince, which knows its own inner ones.
constexpr int outer_steps = 8;

}  // namespace drape
