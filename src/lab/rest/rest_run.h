#pragma once

#include <string>

#include "drape/contact/response.h"
#include "drape/integrate/integrator.h"
#include "drape/scene/settings.h"

namespace drape {

/// At which methods without a step limit run [s].
inline constexpr double long_step = 1.0 / 60;

/// What decides how a scene comes to rest.
struct RestCase {
    std::string scene;
    IntegratorKind integrator{};
    ResponseKind response{};
};

/// How a scene has come to rest. All of it is measured without sleep: the scene moves on after the moment at which it
/// would have fallen asleep.
struct RestRun {
    double step = 0;           ///< [s]
    bool diverged = false;     ///< and ended early
    double asleep = -1;        ///< when it would have fallen asleep; -1: never [s]
    double speed_before = -1;  ///< RMS of what particles moved by in the half second before that; -1: never [m/s]
    double speed_after = 0;    ///< the same of the last half second of the run [m/s]
};

/// The settings of a shipped scene with another integrator and response, at the step of the scene under a method that
/// has a step limit, halved until it is below nine tenths of the limits of method and penalty, else at `long_step`.
/// @param particles on each side of its cloth; 0: as shipped. The drag on the whole cloth stays the same.
/// @return dt = 0 where no step above a 64th of that is stable
Settings rest_settings(const RestCase& one, int particles);

/// Runs until two seconds after it would have fallen asleep.
/// @param seconds simulated at most
/// @param settings whose `sleep_speed` decides when that is
RestRun run_to_rest(const std::string& scene, Settings settings, double seconds);

/// How far a cloth that rests creeps. Measured without sleep.
struct DriftRun {
    bool diverged = false;  ///< and ended early
    double drift = 0;       ///< the farthest that any particle was from where it had come to rest [m]
    double speed = 0;       ///< RMS of what particles moved by in the last half second [m/s]
};

/// Lets a scene come to rest, and then looks once a simulated second how far its first cloth has crept.
/// @param settle when it counts as at rest [s]
/// @param seconds for which it is watched then
DriftRun watch_drift(const std::string& scene, Settings settings, double settle, double seconds);

}  // namespace drape
