#pragma once

#include <string>
#include <vector>

#include "drape/sim/settings.h"

namespace drape {

/// A motion that methods are compared on: a cloth that starts at rest, with or without a ball in its way.
struct PrecisionScene {
    std::string name;
    Settings settings;    ///< one cloth; without method and step
    Real horizon;         ///< at which states are compared [s]
    int rungs;            ///< steps of a method with a step limit, each half of the one before
    int finest_steps;     ///< the most that a method without a step limit takes to the horizon
    int reference_steps;  ///< with a ball: those of the last rung of the reference
    int phases;           ///< with a ball: places of the first impact within a step that errors are averaged over
    Real side() const { return settings.cloths.front().width; }  ///< of the cloth [m]
    bool has_ball() const { return !settings.balls.empty(); }
};

/// Two sheets without contact, of soft and of stiff springs, and one that falls on a ball.
/// @param quick smaller sheets, fewer steps
std::vector<PrecisionScene> precision_scenes(bool quick);

}  // namespace drape
