#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drape/integrate/integrator.h"
#include "drape/scene/settings.h"

namespace drape {

/// A method under its step, or the tolerance that it is set to.
struct Rung {
    IntegratorParameters parameters;
    int steps;  ///< to the horizon
};

/// Dormand-Prince, which knows its own steps within a few.
Rung solved_closely(Real tolerance);

/// A motion that methods are compared on: a cloth that starts at rest, with or without a ball in its way.
struct PrecisionScene {
    std::string name;
    Settings settings;  ///< one cloth, of 1 m; without method and step
    Real horizon;       ///< at which states are compared [s]
    int rungs;          ///< steps of a method with a step limit, each half of the one before
    int finest_steps;   ///< the most that a method without a step limit takes to the horizon
    int phases;         ///< with a ball: phases of the first impact within a step that errors are averaged over
    /// Ever closer: the first for the growth of errors, the second for the error of the third, which is taken for the
    /// truth. Without a ball: of Dormand-Prince. With one, where the step decides when an impact is noticed: of
    /// velocity Verlet, so short that its own error is far below that of the impacts.
    std::array<Rung, 3> reference;
    bool has_ball() const { return !settings.balls.empty(); }
};

/// Two sheets without contact, of soft and of stiff springs, and one that falls on a ball.
/// @param quick smaller sheets, fewer steps
std::vector<PrecisionScene> precision_scenes(bool quick);

/// Where a run ends.
struct Finish {
    ClothState state;
    bool bounded;
    int inner_steps;  ///< of Dormand-Prince
    double cost;  ///< CPU time of a simulated second, but for the first step, in which methods set up what they keep
};

/// Runs a scene to its horizon, in equal steps.
/// @param phase in (0, 1): in one more step, of which the first is cut to that part and the last to the rest, so that
///        what happens on the way falls elsewhere within a step
/// @param start where it begins if not at rest
Finish finish(const PrecisionScene& scene, const Rung& rung, Real phase = 0,
              const std::optional<ClothState>& start = {});

/// What is taken for the truth at the horizon of a scene, and what that is worth.
struct Reference {
    ClothState state;
    double growth;  ///< of `small_error`, on the way to the horizon
    double error;   ///< its own: what the last rung has changed
};

/// @par Cost seconds
Reference find_reference(const PrecisionScene& scene);

}  // namespace drape
