#pragma once

#include <string>

#include "drape/contact/response.h"
#include "drape/integrate/integrator.h"
#include "drape/scene/settings.h"
#include "lab/experiment/row.h"

namespace drape {

/// At which methods without a step limit run [s].
inline constexpr double long_step = 1.0 / 60;

/// What decides how a scene comes to rest.
struct RestCase {
    std::string scene;
    IntegratorKind integrator{};
    ResponseKind response{};
};

/// The settings of a shipped scene with another integrator and response, at the step of the scene under a method that
/// has a step limit, halved until it is below nine tenths of the limits of method and penalty, else at `long_step`.
/// @param particles on each side of its cloth; 0: as shipped. The drag on the whole cloth stays the same.
/// @return dt = 0 where no step above a 64th of that is stable
Settings rest_settings(const RestCase& one, int particles);

// Each measures without sleep and gives some cells of a row of the experiment `rest`: `end`, `speed_after_m_per_s`, the
// RMS of what particles moved by in the last half second, unless it has diverged and ended early, and more.

/// Runs until two seconds after it would have fallen asleep.
/// @param seconds simulated at most
/// @param settings whose `sleep_speed` decides when that is
/// @return also `step_s`, and if it falls asleep `asleep_s`, when, and `speed_before_m_per_s`, in the half second
/// before
Row run_to_rest(const std::string& scene, Settings settings, double seconds);

/// Lets a scene come to rest, and then looks once a simulated second how far its first cloth has crept.
/// @param settle when it counts as at rest [s]
/// @param seconds for which it is watched then
/// @return also `drift_m`, the farthest that any particle was from where it had come to rest, unless it has diverged
Row watch_drift(const std::string& scene, Settings settings, double settle, double seconds);

}  // namespace drape
