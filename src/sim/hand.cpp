#include "drape/sim/hand.h"

#include <algorithm>
#include <string>

#include "drape/base/input_error.h"
#include "drape/model/forces.h"

namespace drape {
namespace {

/// How fast the hand pulls, and the time in which it closes a small gap.
constexpr Real hand_speed = 3;         // m/s
constexpr Real hand_lag = Real(0.03);  // s

void check_number(const char* what, int number, std::size_t count) {
    if (number >= 0 && static_cast<std::size_t>(number) < count) return;
    throw InputError("grab: " + std::string(what) + " " + std::to_string(number) + ": allowed 0 to " +
                     std::to_string(count - 1));
}

/// What the hand holds cannot be pushed out of the balls: it stays outside.
Vec3 outside(Vec3 target, std::span<const Ball> balls, Real thickness) {
    for (const Ball& ball : balls) {
        const Vec3 offset = target - ball.centre;
        const Real least = ball.radius + thickness, distance = offset.norm();
        if (distance < least) target = ball.centre + (distance > 0 ? Vec3(offset / distance) : Vec3(0, 1, 0)) * least;
    }
    return target;
}

/// The most energy a second that the hand, which moves a held particle as its velocity says, puts in at a moment [W]:
/// the work against the forces of springs, air and gravity on that particle; less than zero where they pull it along.
double hand_power(const ClothModel& model, const ClothState& state, int particle) {
    return -static_cast<double>(force_on(model, state.x, state.v, particle).dot(state.v.row(particle)));
}

}  // namespace

void Hand::grab(const command::Grab& command, std::span<Cloth> cloths) {
    check_number("cloth", command.cloth, cloths.size());
    const auto number = static_cast<std::size_t>(command.cloth);
    Cloth& cloth = cloths[number];
    check_number("particle", command.particle, static_cast<std::size_t>(cloth.model.grid.particles()));
    release(cloths);
    held_ = Held{number, command.particle, cloth.state.x.row(command.particle).transpose(),
                 cloth.model.pinned(command.particle)};
    cloth.energy.touch(cloth.model, cloth.state);
    cloth.model.hold(command.particle, true);
}

void Hand::drag(const Vec3& target) {
    if (held_) held_->target = target;
}

void Hand::release(std::span<Cloth> cloths) {
    if (!held_) return;
    Cloth& cloth = cloths[held_->cloth];
    cloth.energy.touch(cloth.model, cloth.state);
    if (held_->was_pinned) {
        cloth.state.v.row(held_->particle).setZero();
    } else {
        cloth.model.hold(held_->particle, false);
    }
    held_.reset();
}

void Hand::hold_in(std::size_t cloth, ClothModel& model) const {
    if (held_ && held_->cloth == cloth) model.hold(held_->particle, true);
}

void Hand::lead(std::span<Cloth> cloths, std::span<const Ball> balls, Real thickness, Real h) {
    if (!held_) return;
    Cloth& cloth = cloths[held_->cloth];
    const Vec3 here = cloth.state.x.row(held_->particle).transpose();
    Vec3 velocity = (outside(held_->target, balls, thickness) - here) / std::max(hand_lag, h);
    const Real speed = velocity.norm();
    if (speed > hand_speed) velocity *= hand_speed / speed;
    const Real gained = velocity.squaredNorm() - cloth.state.v.row(held_->particle).squaredNorm();
    cloth.energy.give(static_cast<double>(cloth.model.particle_mass / 2 * std::max(gained, Real(0))));
    cloth.energy.touch(cloth.model, cloth.state);
    cloth.state.v.row(held_->particle) = velocity.transpose();
    held_->power = hand_power(cloth.model, cloth.state, held_->particle);
}

/// The larger of both ends of the step stands for all of it: a spring that is drawn out pulls ever more.
void Hand::count_work(std::span<Cloth> cloths, Real h) const {
    if (!held_) return;
    Cloth& cloth = cloths[held_->cloth];
    const double power = hand_power(cloth.model, cloth.state, held_->particle);
    cloth.energy.give(std::max({held_->power, power, 0.0}) * static_cast<double>(h));
}

}  // namespace drape
