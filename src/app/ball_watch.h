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
    bool loses(const Simulation& simulation, bool is_seen, const Vec3& target, double elapsed) {
        constexpr Real min_speed = Real(0.05);  // m/s
        const std::size_t number = simulation.users_ball();
        const BallMotion motion = simulation.settings().balls[number].motion;
        const Ball& ball = simulation.balls()[number];
        const bool is_users = motion == BallMotion::Free || motion == BallMotion::Keys;
        const bool moves = is_users && !simulation.paused() && simulation.report().status == Status::Ok;
        if (is_seen || !moves || ball.velocity.dot((ball.centre - target).normalized()) < min_speed) {
            away_ = 0;
            return false;
        }
        const bool was_lost = away_ >= patience;
        away_ += elapsed;
        return !was_lost && away_ >= patience;
    }

    static constexpr double patience = 1;  ///< [s]

private:
    double away_ = 0;  ///< for how long [s]
};

}  // namespace drape
