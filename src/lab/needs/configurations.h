#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "drape/base/enum_names.h"
#include "drape/scene/settings.h"
#include "lab/measure/methods.h"

namespace drape {

/// A setting that the search for what a scene needs may change.
enum class Knob { Particles, Bend, Drag, Integrator, Dt, Iterations, Volume, Update, SphereFit, LeafCells };

/// The knobs that change the motion and have an order: a scene can have one notch less of each.
inline constexpr std::array ordered_knobs{Knob::Particles, Knob::Bend, Knob::Drag, Knob::Dt, Knob::Iterations};

/// Those that say how contacts with balls are looked for.
inline constexpr std::array hierarchy_knobs{Knob::Volume, Knob::Update, Knob::SphereFit, Knob::LeafCells};

/// The knobs that a scene leaves free: all but those in its `needs.keep` and those with nothing to act on. Particles
/// stay where pins or a start state count them, and the hierarchy where there is no ball to search for.
/// @throws InputError if `needs.keep` has a word that names no knob
std::set<Knob> free_knobs(const Settings& scene);

/// The steps that are tried, longest first: ten a decade, rounded so that nearly all divide a tenth of a second [s].
inline constexpr std::array step_ladder{1.6e-2, 1.25e-2, 1e-2, 8e-3, 6.25e-3, 5e-3, 4e-3, 3.125e-3, 2.5e-3, 2e-3,
                                        1.6e-3, 1.25e-3, 1e-3, 8e-4, 6.25e-4, 5e-4, 4e-4, 3.125e-4, 2.5e-4, 2e-4,
                                        1.6e-4, 1.25e-4, 1e-4, 8e-5, 6.25e-5, 5e-5, 4e-5, 3.125e-5, 2.5e-5, 2e-5,
                                        1.6e-5, 1.25e-5, 1e-5};

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

/// The file in which a scene is written back: its own, or NAME.toml in the current folder if it is a shipped one's
/// name.
/// @throws InputError if a shipped one's name is that of a file in the current folder, which is another scene, or if a
///         scene in that file may not name the state from which this one starts
std::filesystem::path file_of_scene(const std::string& name_or_path, const Settings& scene);

/// Writes a scene file whole or not at all: under another name, which then becomes its own. A file that was there stays
/// as NAME.toml~, and hands on its permissions; through a link, the file that it leads to is written.
/// @param full is said in `needs.full`, so that the scene can be found again
/// @throws RunError if it cannot be written
void write_scene(Settings scene, const Settings& full, const std::filesystem::path& file);

}  // namespace drape
