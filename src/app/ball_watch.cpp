#include "ball_watch.h"

namespace drape {

bool BallWatch::loses(const Simulation& simulation, bool is_seen, const Vec3& target, double elapsed) {
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

}  // namespace drape
