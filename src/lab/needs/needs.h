#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "drape/scene/settings.h"
#include "drape/scene/start_state.h"
#include "lab/measure/statistics.h"

namespace drape {

// Configurations of a scene

/// A setting that the search for what a scene needs may change.
enum class Knob { Particles, Bend, Drag, Integrator, Dt, Iterations, Volume, Update, SphereFit, LeafCells };

/// Those that say how contacts with balls are looked for.
inline constexpr std::array hierarchy_knobs{Knob::Volume, Knob::Update, Knob::SphereFit, Knob::LeafCells};

/// The knobs that a scene leaves free: all but those in its `needs.keep` and those with nothing to act on. Particles
/// stay where pins or a start state count them, and the hierarchy where there is no ball to search for.
/// @throws InputError if `needs.keep` has a word that names no knob
std::set<Knob> free_knobs(const Settings& scene);

/// A scene with one notch less of a knob: four fifths of the cells a side, no bend springs, no drag, the next longer
/// step of the ladder, or one iteration less. Nothing if there is no less, or the scene does not leave it free.
std::optional<Settings> one_notch_less(const Settings& scene, Knob knob);

/// The scene's cloth with other particles: mass, drag on the whole and stiffnesses stay.
Settings on_grid(Settings scene, const Grid& grid);

/// The step at which the full model is computed [s]. Contact makes every method one of first order, so it is short.
constexpr double close_step = 1e-4;

/// The scene with all that its model could have: the particles, bend springs and drag of `needs.full`.
/// @throws InputError if the scene has several cloths, or `needs.full.particles` is no grid
Settings full_model(const Settings& scene);

/// A scene, computed so closely that only its model is left to err: by Dormand-Prince between contacts, which are those
/// of each step, and looked for without a limit.
/// @param dt [s]
Settings computed_closely(Settings scene, double dt);

// How a scene moves

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

// What is needed, and what is enough

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

/// A scene as the text of a file.
/// @param full is said in `needs.full`, so that the scene can be found again
/// @param file that it is for
/// @throws InputError if the scene's start is not in the file's folder or below, where a scene may name it
std::string text_of_found(Settings scene, const Settings& full, const std::filesystem::path& file);

}  // namespace drape
