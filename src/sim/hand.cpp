#include "drape/sim/hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "drape/base/input_error.h"
#include "drape/model/forces.h"
#include "drape/model/stencils.h"
#include "drape/model/stretch_limit.h"

namespace drape {
namespace {

/// How fast the hand pulls, and the time in which it closes a small gap.
constexpr Real hand_speed = 3;         // m/s
constexpr Real hand_lag = Real(0.03);  // s

/// The most that the hand pulls by, of the cloth's weight: it lifts all of the cloth, and speeds it up by twice
/// gravity. Beside the hand a shipped cloth is then stretched by a sixth.
constexpr Real hand_weights = 3;

/// Rounds to find the velocity at the bound; each is left with at most some two thirds of the excess.
constexpr int hand_rounds = 12;

void check_number(const std::string& what, int number, std::size_t count) {
    if (number >= 0 && static_cast<std::size_t>(number) < count) return;
    throw InputError(what + " " + std::to_string(number) + ": allowed 0 to " + std::to_string(count - 1));
}

/// How far above a ball and the cloth's thickness the hand stays, so that contacts with it are at other corners of the
/// triangles around it: contacts cannot push what is held. A chord of the length d dips d^2/(8r) into a ball; twice
/// that leaves the half of each triangle that is at the held corner outside.
Real clearance(const ClothModel& model, const Ball& ball) {
    const Real square = model.hx * model.hx + model.hy * model.hy;
    return std::min(square / (4 * ball.radius), std::sqrt(square) / 4);
}

/// Out of one ball, the shortest way; where that leads into the ground, along the ground.
/// @pre target at `lowest` or higher, all in [m]
Vec3 out_of_ball(const Ball& ball, Real least, Real lowest, const Vec3& target) {
    const Vec3 offset = target - ball.centre;
    const Real distance = offset.norm();
    if (distance >= least) return target;
    const Vec3 nearest = ball.centre + (distance > 0 ? Vec3(offset / distance) : Vec3(0, 1, 0)) * least;
    if (nearest.y() >= lowest) return nearest;
    const Real below = lowest - ball.centre.y();
    const Vec3 level(offset.x(), 0, offset.z());
    const Vec3 along = level.isZero(0) ? Vec3(1, 0, 0) : Vec3(level.normalized());
    return ball.centre + Vec3(0, below, 0) + std::sqrt(std::max(least * least - below * below, Real(0))) * along;
}

/// Out of one solid, the shortest way; where the surface curves, a few times.
Vec3 out_of_solid(const Solid& solid, Real least, Vec3 target) {
    constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round) {
        const SurfaceDistance surface = solid.measure(target);
        if (surface.distance >= least) break;
        target += (least - surface.distance) * surface.normal;
    }
    return target;
}

/// What the hand holds cannot be pushed: it stays outside balls, solids and ground.
Vec3 outside(const ClothModel& model, Vec3 target, const Obstacles& obstacles) {
    const Real lowest =
        obstacles.ground.solid ? obstacles.ground.height + obstacles.thickness : -std::numeric_limits<Real>::infinity();
    target.y() = std::max(target.y(), lowest);
    for (std::size_t round = 0; round < obstacles.balls.size(); ++round) {
        for (const Ball& ball : obstacles.balls) {
            const Real least = ball.radius + obstacles.thickness + clearance(model, ball);
            target = out_of_ball(ball, least, lowest, target);
        }
    }
    for (const Solid& solid : obstacles.solids) target = out_of_solid(solid, obstacles.thickness, target);
    return target;
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
    grab_ = Grab{number, command.particle, cloth.state.x.row(command.particle).transpose(),
                 cloth.model.pinned(command.particle)};
    cloth.energy.touch(cloth.model, cloth.state);
    cloth.model.hold(command.particle, true);
    cloth.grabbed = command.particle;
}

void Hand::release(std::span<Cloth> cloths) {
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

void Hand::lead(std::span<Cloth> cloths, const Obstacles& obstacles, Real h) {
    if (!grab_) return;
    Cloth& cloth = cloths[grab_->cloth];
    const Vec3 here = cloth.state.x.row(grab_->particle).transpose();
    Vec3 velocity = (outside(cloth.model, grab_->target, obstacles) - here) / std::max(hand_lag, h);
    const Real speed = velocity.norm();
    if (speed > hand_speed) velocity *= hand_speed / speed;
    const Grip grip{cloth.model, cloth.state, grab_->particle, h};
    velocity = within_limit(grip, within_bound(grip, velocity));
    velocity = (outside(cloth.model, here + h * velocity, obstacles) - here) / h;
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
