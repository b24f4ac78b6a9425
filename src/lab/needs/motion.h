#pragma once

#include <array>
#include <limits>
#include <optional>

#include "drape/sim/settings.h"
#include "drape/sim/start_state.h"

namespace drape {

/// What a scene showed on its way to the horizon of its needs.
struct Motion {
    static constexpr int moments = 16;  ///< at equal distances, the last at the horizon

    Grid grid;
    ClothState start;               ///< the first cloth before the first step
    std::array<Points, moments> x;  ///< the first cloth at each moment; as far as it came
    int reached = 0;                ///< moments
    bool diverged = false;
    bool given_up = false;       ///< it was too expensive, or its step too long
    double time = 0;             ///< to which it came, from its start [s]
    double step_over_limit = 0;  ///< length of a step over its limit, as predicted
    double penetration = 0;      ///< largest after any step, of its last substep [m]
    double stretch = 0;          ///< largest after any step
    double cost = 0;             ///< CPU time of all threads per simulated second [s/s]
};

/// Beyond which a run is not worth its time.
struct Patience {
    double cost = std::numeric_limits<double>::infinity();  ///< CPU time of all threads per simulated second [s/s]
    double step_over_limit = std::numeric_limits<double>::infinity();  ///< a longer step is not even begun with
};

/// The larger of two; what is no number is larger than all, so that it is not missed.
double larger(double a, double b);

/// Runs a scene to the horizon of its needs, or until it diverges or is given up. Between two steps a moment is
/// interpolated by a cubic of both states (Hermite's), which no second-order method feels.
/// Cost is that of the steps alone: stretch, which is measured after each, adds a root per structural spring to the
/// run and nothing to its cost.
/// @param start where it begins if not where the scene says
Motion run_to_horizon(const Settings& scene, const Patience& patience = {},
                      const std::optional<StartState>& start = {});

/// How far a motion is from that of the full model, of the cloth's longer side: the largest over all moments. The
/// particles of the one are compared with the places of the other's cloth at which they lie, by bilinear
/// interpolation between its particles. No number if either is not of numbers.
/// @pre both have reached all moments
double motion_error(const Motion& motion, const Motion& full, NeedsMeasure measure, Real side);

}  // namespace drape
