#pragma once

#include <optional>
#include <vector>

#include "drape/scene/start_state.h"
#include "drape/sim/contact_stage.h"

namespace drape {

/// A simulation without all that contact does not need: the integrator and the contact stage of `Simulation`, to the
/// same bits, but that it does not divide steps. Balls go their way at constant velocity whatever they meet.
struct ContactTrial {
    /// @param start of the cloths; none: at rest
    explicit ContactTrial(Settings of, const std::optional<StartState>& start = {});

    /// Moves balls and cloths by a step of that length [s] and finds what then touches.
    void advance(Real h);

    /// Answers what was found.
    void respond();

    /// Of a cloth [kg m/s].
    [[nodiscard]] Vec3 momentum(std::size_t cloth) const;

    Settings settings;
    std::vector<Cloth> cloths;
    std::vector<Ball> balls;
    ContactStage stage;
    StepReport report;  ///< of the last step
    Points unpushed;    ///< where the integrator has left the first cloth [m]
};

}  // namespace drape
