#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "configurations.h"
#include "drape/scene/settings.h"
#include "drape/scene/start_state.h"
#include "lab/measure/statistics.h"

namespace drape {

/// What a scene showed on its way to the horizon of its needs.
struct Motion {
    static constexpr std::size_t moments = 16;  ///< at equal distances, the last at the horizon

    Grid grid;
    std::vector<Points> x;  ///< the first cloth at each moment, as far as it came
    bool diverged = false;
    bool given_up = false;       ///< it was too expensive
    double time = 0;             ///< to which it came, from its start [s]
    double step_over_limit = 0;  ///< length of a step over its limit, as predicted
    double penetration = 0;      ///< largest after any step, of its last substep [m]
    double stretch = 0;          ///< largest after any step
    double cost = 0;             ///< CPU time of all threads per simulated second [s/s]
    double wall = 0;             ///< the same by a clock [s/s]
};

/// Stands for: no limit.
inline constexpr double no_bound = std::numeric_limits<double>::infinity();

/// The larger of two; what is no number is larger than all, so that it is not missed.
double larger(double a, double b);

/// Runs a scene to the horizon of its needs, or until it diverges or is given up. Between two steps a moment is
/// interpolated by a cubic of both states (Hermite's), which no second-order method feels.
/// Cost is that of the steps alone: stretch, which is measured after each, adds a root per structural spring to the
/// run and nothing to its cost.
/// @param cost_limit CPU time of all threads per simulated second [s/s]: beyond it the run is not worth its time
/// @param start where it begins if not where the scene says
Motion run_to_horizon(const Settings& scene, double cost_limit = no_bound, const std::optional<StartState>& start = {});

/// How far a motion is from that of the full model, of the cloth's longer side: the largest over all moments. The
/// particles of the one are compared with the points of the other's cloth at which they lie, by bilinear
/// interpolation between its particles. No number if either is not of numbers.
/// @pre both have passed all moments
double motion_error(const Motion& motion, const Motion& full, NeedsMeasure measure, Real side);

/// What a scene's needs say about a configuration that was tried.
struct Attempt {
    Settings settings;
    double error = no_number;   ///< against the full model, of the cloth's side; if one is stated, and compared
    double cost = 0;            ///< CPU time of all threads per simulated second [s/s]
    double miss = 0;            ///< the worst of what was measured over what is allowed; above 1 it does not qualify
    bool beyond_limit = false;  ///< its step is too near to the method's limit, or above: it was not run
    std::string why = {};       ///< it does not qualify; empty if it does

    [[nodiscard]] bool qualifies() const { return why.empty(); }
};

/// Whether a scene says anything that it must show.
bool states_needs(const NeedsSettings& needs);

/// What a scene must show, and whether a configuration of it does.
class Needs {
public:
    /// Computes the full model, where an error against it is stated.
    /// @throws InputError if nothing is stated
    /// @throws RunError if the full model itself diverges
    explicit Needs(Settings scene);

    /// Runs a configuration and says whether it qualifies. Besides what the scene states, a method with a limited step
    /// must keep below nine tenths of it, as `on_unstable = "substep"` does; but for a scene that is to diverge.
    /// @param cost_limit it is given up where it costs more [s/s]
    [[nodiscard]] Attempt attempt(const Settings& settings, double cost_limit = no_bound) const;

    /// Finds out what the full model is worth: by how much it differs at twice its step or from a disturbed start.
    /// @return a line that says so; empty if no error is stated
    /// @throws InputError if particles are to be compared where a small error grows beyond `most_growth`
    /// @throws RunError if it is known too little for the error that the scene allows
    [[nodiscard]] std::string check_full_model() const;

    [[nodiscard]] const Settings& scene() const { return scene_; }
    [[nodiscard]] const Settings& full() const { return full_; }
    [[nodiscard]] bool states_error() const { return scene_.needs.position_error > 0; }

    /// How far a motion is from the full model's, or from another, as the scene measures it, of the cloth's side.
    /// @pre an error is stated, and both have passed all moments
    [[nodiscard]] double error_of(const Motion& motion) const { return error_of(motion, *motion_); }
    [[nodiscard]] double error_of(const Motion& motion, const Motion& other) const;

private:
    Settings scene_, full_;
    std::optional<Motion> motion_;  ///< of the full model
};

/// A part of the cloth's side as a text in per cent.
std::string percent(double part);

/// Is told each attempt, with what became of it: "kept", "cheapest so far", or why it was rejected.
using Trail = std::function<void(const Attempt&, const std::string& outcome)>;

/// Looks for the cheapest configuration that shows what the scene needs.
///
/// First the model: with everything computed closely, particles, bend springs and drag are taken away notch by notch as
/// far as the needs allow. Then the method: for each of these models, the least first, each integrator's longest step
/// that qualifies, as long as it is not more expensive than the cheapest so far. Then every knob once more, until one
/// notch less on any that has an order breaks a need. Last, how contacts are looked for: by cost alone, unless the
/// search has a limit, for then that changes the motion too. A scene that does not state an error has no full model: it
/// is taken as it is, and only notches are taken away.
/// @return where none qualifies, the nearest miss
Attempt search(const Needs& needs, const Trail& trail);

/// Tries a scene with one notch less of each of its free knobs that has an order. It is minimal if none qualifies.
void try_notches(const Needs& needs, const std::function<void(Knob, const Attempt&)>& note);

}  // namespace drape
