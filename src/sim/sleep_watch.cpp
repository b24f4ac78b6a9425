#include "drape/sim/sleep_watch.h"

#include <algorithm>

#include "drape/bounds/displacement.h"

namespace drape {
namespace {

/// How far a particle may go in the time of a watch and count as resting: no small cloth swings in so little either.
Real resting_distance(const ClothModel& model, Real speed) {
    return std::min(speed * static_cast<Real>(RestWatch::duration), std::min(model.width(), model.height()) / 1000);
}

}  // namespace

bool RestWatch::look(const Points& x, double time, Real distance) {
    if (!watching_ || largest_displacement(x, start_) > distance) {
        watching_ = true;
        since_ = time;
        start_ = x;
    }
    return time - since_ >= duration;
}

void SleepWatch::restart() {
    for (RestWatch& watch : watches_) watch.restart();
    ball_watch_.restart();
}

bool SleepWatch::balls_rest(std::span<const Ball> balls, double time, Real speed) {
    if (std::ranges::none_of(balls, [](const Ball& ball) { return ball.inverse_mass > 0; })) return true;
    centres_.resize(static_cast<Eigen::Index>(balls.size()), 3);
    for (std::size_t b = 0; b < balls.size(); ++b) {
        centres_.row(static_cast<Eigen::Index>(b)) = balls[b].centre.transpose();
        if (balls[b].radius * balls[b].spin.norm() > speed) ball_watch_.restart();
    }
    return ball_watch_.look(centres_, time, speed * static_cast<Real>(RestWatch::duration));
}

bool SleepWatch::look(std::span<const Cloth> cloths, std::span<const Ball> balls, double time, Real speed) {
    watches_.resize(cloths.size());
    bool all_rest = balls_rest(balls, time, speed);
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        all_rest = watches_[c].look(cloths[c].state.x, time, resting_distance(cloths[c].model, speed)) && all_rest;
    }
    return all_rest;
}

}  // namespace drape
