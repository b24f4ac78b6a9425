#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drape/integrate/integrator.h"
#include "drape/scene/settings.h"
#include "lab/experiment/experiment.h"
#include "lab/measure/states.h"
#include "lab/measure/statistics.h"

namespace drape {

/// A motion that methods are compared on: a cloth that starts at rest, with or without a ball in its way.
struct PrecisionScene {
    std::string name;
    Settings settings;    ///< one cloth; without method and step
    Real horizon;         ///< at which states are compared [s]
    int rungs;            ///< steps of a method with a step limit, each half of the one before
    int finest_steps;     ///< the most that a method without a step limit takes to the horizon
    int reference_steps;  ///< with a ball: those of the last rung of the reference
    int phases;           ///< with a ball: phases of the first impact within a step that errors are averaged over
    Real side() const { return settings.cloths.front().width; }  ///< of the cloth [m]
    bool has_ball() const { return !settings.balls.empty(); }
};

/// Two sheets without contact, of soft and of stiff springs, and one that falls on a ball.
/// @param quick smaller sheets, fewer steps
std::vector<PrecisionScene> precision_scenes(bool quick);

/// A method under its step, or the tolerance that it is set to.
struct Rung {
    IntegratorParameters parameters;
    int steps;  ///< to the horizon
};

/// The steps to a horizon: `count` equal ones, or with a phase in (0, 1) one more, of which the first is cut to that
/// part and the last to the rest, so that what happens on the way falls elsewhere within a step [s].
std::vector<Real> steps_to(Real horizon, int count, Real phase = 0);

/// Where a run ends.
struct Finish {
    ClothState state;
    bool bounded;
    int inner_steps;  ///< of Dormand-Prince
};

/// Runs a scene to its horizon.
/// @param phase see `steps_to`
/// @param start where it begins if not at rest
Finish finish(const PrecisionScene& scene, const Rung& rung, Real phase = 0,
              const std::optional<ClothState>& start = {});

/// CPU time of a simulated second [s/s], over runs of equal steps to the horizon after one that warms up. The first
/// step of each is left out: in it, methods set up what they keep.
Quartiles cost_of(const PrecisionScene& scene, const Rung& rung, int repeats);

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

/// A work-precision diagram a scene.
/// @throws RunError if the reference of a scene is not two decades better than the best point: nothing is drawn then
std::vector<Chart> precision_charts(const Rows& rows);

}  // namespace drape
