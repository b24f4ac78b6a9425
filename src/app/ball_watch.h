#pragma once

#include "drape/sim/simulation.h"

namespace drape {

/// Finds out when the user has lost sight of the ball that X throws.
class BallWatch {
public:
    /// @param is_seen whether the picture shows the user's ball
    /// @param target of the camera [m]
    /// @param elapsed since the last call [s]
    /// @return whether the ball has moved away out of the picture for a while now; once until it turns back
    /// @pre the scene has a ball
    bool loses(const Simulation& simulation, bool is_seen, const Vec3& target, double elapsed);

    static constexpr double patience = 1;  ///< [s]

private:
    double away_ = 0;  ///< for how long [s]
};

}  // namespace drape
