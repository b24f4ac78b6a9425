#include <algorithm>

#include "body_motion.h"
#include "drape/base/input_error.h"
#include "drape/sim/simulation.h"

namespace drape {

/// With other motions another ball may be the user's, unless one has been taken over.
void Simulation::configure_balls(const Settings& before) {
    bool other_motion = false;
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        const BallSettings &now = settings_.balls[b], &then = before.balls[b];
        if (now.motion != then.motion && b == users_ball_) motion_by_scene_.reset();
        other_motion = other_motion || now.motion != then.motion;
        if (now.radius != then.radius) contact_.forget_bodies([&](int body) { return body == static_cast<int>(b); });
        balls_[b].radius = now.radius;
        balls_[b].inverse_mass = inverse_mass_of(now);
        if (now.position != then.position) put_ball(b, now.position);
        if (now.velocity != then.velocity) balls_[b].velocity = now.velocity;
    }
    if (other_motion && !motion_by_scene_) choose_ball();
}

/// Nothing that touched the ball where it was does so where it is now.
void Simulation::put_ball(std::size_t number, const Vec3& centre) {
    balls_[number].centre = centre;
    contact_.forget_bodies([&](int body) { return body == static_cast<int>(number); });
}

/// The user's ball is the first of the keys, or else the first free one, or else the first of all.
void Simulation::choose_ball() {
    users_ball_ = 0;
    for (const BallMotion motion : {BallMotion::Keys, BallMotion::Free}) {
        const auto found = std::ranges::find(settings_.balls, motion, &BallSettings::motion);
        if (found == settings_.balls.end()) continue;
        users_ball_ = static_cast<std::size_t>(found - settings_.balls.begin());
        return;
    }
}

/// The user takes the ball over, until the scene starts again.
void Simulation::move_ball_by(BallMotion motion) {
    if (balls_.empty()) throw InputError("this scene has no ball");
    BallSettings& ball = settings_.balls[users_ball_];
    if (ball.motion == motion) return;
    if (!motion_by_scene_) motion_by_scene_ = ball.motion;
    ball.motion = motion;
    balls_[users_ball_].inverse_mass = inverse_mass_of(ball);
    wake();
}

void Simulation::throw_ball(const command::Throw& command) {
    move_ball_by(BallMotion::Free);
    put_ball(users_ball_, command.from);
    balls_[users_ball_].velocity = command.velocity;
    balls_[users_ball_].spin.setZero();
    wake();
}

}  // namespace drape
