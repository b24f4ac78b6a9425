#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "drape/base/enum_names.h"
#include "drape/sim/settings.h"

namespace drape {

/// A setting that the search for what a scene needs may change.
enum class Knob { Particles, Bend, Drag, Integrator, Dt, Iterations, Volume, Update, SphereFit, LeafCells };

template <>
inline constexpr auto enum_names<Knob> = all_names<Knob>("particles", "bend", "drag", "integrator", "dt", "iterations",
                                                         "volume", "update", "sphere_fit", "leaf_cells");

/// The knobs that a scene leaves free: all but those in its `needs.keep` and those with nothing to act on. Particles
/// stay where pins or a start state count them, and the hierarchy where there is no ball to search for.
/// @throws InputError if `needs.keep` has a word that names no knob
std::set<Knob> free_knobs(const Settings& scene);

/// The knobs that change the motion and have an order: a scene can have one notch less of each.
std::span<const Knob> ordered_knobs();

/// A scene with one notch less of a knob: four fifths of the cells a side, no bend springs, no drag, the next longer
/// step of the ladder, or one iteration less. Nothing if there is no less.
std::optional<Settings> one_notch_less(const Settings& scene, Knob knob);

/// The steps that are tried, longest first: ten a decade, rounded so that nearly all divide a tenth of a second [s].
std::vector<double> step_ladder();

/// The scene's cloth with other particles: mass, drag on the whole and stiffnesses stay.
Settings on_grid(Settings scene, const Grid& grid);

/// Whether a method repeats its passes as often as `solver.iterations` says.
bool has_iterations(IntegratorKind kind);

}  // namespace drape
