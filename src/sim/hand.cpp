#include "drape/sim/hand.h"

#include <algorithm>
#include <string>

#include "drape/base/input_error.h"
#include "drape/model/forces.h"
#include "drape/model/stencils.h"
#include "drape/model/stretch_limit.h"

namespace drape {
namespace {

/// The most that the hand pulls by, of the cloth's weight: it lifts all of the cloth, and speeds it up by twice
/// gravity. Beside the hand a shipped cloth is then stretched by a sixth.
constexpr Real hand_weights = 3;

/// Rounds to find the velocity at the bound; each is left with at most some two thirds of the excess.
constexpr int hand_rounds = 12;

/// The time in which a ball closes a small gap [s]: so much longer than the one in which it follows the hand's
/// velocity that it hardly overshoots.
constexpr Real ball_lag = Real(0.08);

void check_number(const std::string& what, int number, std::size_t count) {
    if (number >= 0 && static_cast<std::size_t>(number) < count) return;
    if (count == 0) throw InputError(what + " " + std::to_string(number) + ": this scene has none");
    throw InputError(what + " " + std::to_string(number) + ": allowed 0 to " + std::to_string(count - 1));
}

/// A held particle and its neighbours at the end of a step, should these go on as they do and it have a velocity v.
struct Grip {
    const ClothModel& model;
    const ClothState& state;
    int particle;
    Real h;

    /// Calls visit(springs, d, w) for each spring at the particle: d [m], w [m/s] from its other end to the particle.
    template <class Visit>
    void for_each_spring(const Vec3& v, Visit visit) const {
        for_each_spring_at(model, particle, [&](const SpringStencil& springs, int other) {
            const Vec3 w = v - state.v.row(other).transpose();
            visit(springs, (state.x.row(particle) - state.x.row(other)).transpose() + h * w, w);
        });
    }
};

/// The velocity nearest to the wanted one at which the springs pull by no more than the bound, in rounds of
/// v += (f - F f/|f|) / slope: none moves too far, for it takes the largest slope of the pull that there can be.
Vec3 within_bound(const Grip& grip, Vec3 v) {
    const ClothModel& model = grip.model;
    const auto particles = static_cast<Real>(model.grid.particles());
    const Real bound = hand_weights * particles * model.particle_mass * gravity_scale(model);
    for (int round = 0; round < hand_rounds; ++round) {
        Vec3 pull = Vec3::Zero();
        Real slope = 0;
        grip.for_each_spring(v, [&](const SpringStencil& springs, const Vec3& d, const Vec3& w) {
            pull += spring_force(springs.law, springs.rest_length, d, w);
            slope += springs.law.stiffness * grip.h + springs.law.damping;
        });
        const Real size = pull.norm();
        if (!(size > bound)) break;
        v += (1 - bound / size) / slope * pull;
    }
    return v;
}

/// A velocity near to the wanted one that stretches no structural spring at the particle beyond the cloth's limit,
/// found one spring after the other.
Vec3 within_limit(const Grip& grip, Vec3 v) {
    const Real limit = grip.model.stretch_limit;
    if (limit == 0) return v;
    for (int round = 0; round < hand_rounds; ++round) {
        const Vec3 wanted = v;
        grip.for_each_spring(wanted, [&](const SpringStencil& springs, const Vec3& there, const Vec3&) {
            const Vec3 d = there + grip.h * (v - wanted);
            const Real length = d.norm(), longest = (1 + limit + stretch_tolerance) * springs.rest_length;
            if (springs.structural() && length > longest) v -= (1 - longest / length) / grip.h * d;
        });
        if (v == wanted) break;
    }
    return v;
}

}  // namespace

void check_particle(const std::string& command, int cloth, int particle, std::span<const Cloth> cloths) {
    check_number(command + ": cloth", cloth, cloths.size());
    const Grid& grid = cloths[static_cast<std::size_t>(cloth)].model.grid;
    check_number(command + ": particle", particle, static_cast<std::size_t>(grid.particles()));
}

void Hand::grab(const command::Grab& command, std::span<Cloth> cloths) {
    check_particle("grab", command.cloth, command.particle, cloths);
    const auto number = static_cast<std::size_t>(command.cloth);
    Cloth& cloth = cloths[number];
    release(cloths);
    target_ = cloth.state.x.row(command.particle).transpose();
    grab_ = Grab{number, command.particle, cloth.model.pinned(command.particle)};
    cloth.energy.touch(cloth.model, cloth.state);
    cloth.model.hold(command.particle, true);
    cloth.grabbed = command.particle;
}

void Hand::hold(const command::Hold& command, std::span<const Ball> balls, std::span<Cloth> cloths) {
    check_number("hold: ball", command.ball, balls.size());
    release(cloths);
    ball_ = command.ball;
    target_ = balls[static_cast<std::size_t>(ball_)].centre;
}

void Hand::release(std::span<Cloth> cloths) {
    ball_ = -1;
    if (!grab_) return;
    Cloth& cloth = cloths[grab_->cloth];
    cloth.energy.touch(cloth.model, cloth.state);
    if (grab_->was_pinned) {
        cloth.state.v.row(grab_->particle).setZero();
    } else {
        cloth.model.hold(grab_->particle, false);
    }
    cloth.grabbed = -1;
    grab_.reset();
}

void Hand::hold_in(std::size_t cloth, ClothModel& model) {
    if (!grab_ || grab_->cloth != cloth) return;
    grab_->was_pinned = model.pinned(grab_->particle);
    model.hold(grab_->particle, true);
}

Vec3 Hand::towards_target(const Vec3& here, Real lag) const {
    Vec3 velocity = (target_ - here) / lag;
    const Real speed = velocity.norm();
    if (speed > hand_speed) velocity *= hand_speed / speed;
    return velocity;
}

std::optional<Vec3> Hand::velocity_of(std::size_t ball, const Vec3& centre, Real h) const {
    if (static_cast<int>(ball) != ball_) return std::nullopt;
    return towards_target(centre, std::max(ball_lag, h));
}

void Hand::lead(std::span<Cloth> cloths, Real h) {
    if (!grab_) return;
    Cloth& cloth = cloths[grab_->cloth];
    const Vec3 here = cloth.state.x.row(grab_->particle).transpose();
    const Grip grip{cloth.model, cloth.state, grab_->particle, h};
    const Vec3 velocity = within_limit(grip, within_bound(grip, towards_target(here, std::max(hand_lag, h))));
    const Real gained = velocity.squaredNorm() - cloth.state.v.row(grab_->particle).squaredNorm();
    cloth.energy.give(static_cast<double>(cloth.model.particle_mass / 2 * std::max(gained, Real(0))));
    cloth.energy.touch(cloth.model, cloth.state);
    cloth.state.v.row(grab_->particle) = velocity.transpose();
    grab_->power = held_power(cloth.model, cloth.state.x, cloth.state.v, grab_->particle);
}

/// The larger of both ends of the step stands for all of it: a spring that is drawn out pulls ever more.
void Hand::count_work(std::span<Cloth> cloths, Real h) const {
    if (!grab_) return;
    Cloth& cloth = cloths[grab_->cloth];
    const double power = held_power(cloth.model, cloth.state.x, cloth.state.v, grab_->particle);
    cloth.energy.give(std::max({grab_->power, power, 0.0}) * static_cast<double>(h));
}

}  // namespace drape
