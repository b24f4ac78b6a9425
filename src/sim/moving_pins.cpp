#include "drape/sim/moving_pins.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "body_motion.h"
#include "drape/sim/hand.h"

namespace drape {
namespace {

/// What rounding leaves is no gap [m].
constexpr Real min_gap = Real(1e-6);

/// How a pin that has left its way goes back: no faster than the hand would lead it.
Vec3 way_back(const Vec3& gap, Real h) {
    const Real distance = gap.norm();
    if (distance <= min_gap) return Vec3::Zero();
    return std::min(1 / std::max(hand_lag, h), hand_speed / distance) * gap;
}

/// A turn about the direction of a vector by as many whole turns as it is long.
Eigen::Quaternion<Real> turned_by(const Vec3& turns) {
    const Real count = turns.norm();
    if (count == 0) return Eigen::Quaternion<Real>::Identity();
    return turn_about(turns / count, static_cast<double>(count));
}

/// What pins give the cloth at a moment, but for one that the hand holds [W].
double power_of(const std::vector<int>& pins, const Cloth& cloth) {
    double power = 0;
    for (const int p : pins) {
        if (p != cloth.grabbed) power += std::max(held_power(cloth.model, cloth.state.x, cloth.state.v, p), 0.0);
    }
    return power;
}

Vec3 at(const std::vector<PathPoint>& path, Real time) {
    return path.empty() ? Vec3(Vec3::Zero()) : point_on_path(path, time);
}

/// Where a group is at a time.
struct Pose {
    Vec3 shift, turns;
    Eigen::Quaternion<Real> turn;

    Pose(const PinSettings& settings, Real time)
        : shift(at(settings.shift, time)), turns(at(settings.turns, time)), turn(turned_by(turns)) {}

    [[nodiscard]] bool operator==(const Pose& other) const { return shift == other.shift && turns == other.turns; }
    [[nodiscard]] Vec3 of(const Vec3& middle, const Vec3& arm) const { return middle + shift + turn * arm; }
};

}  // namespace

void MovingPins::use(const Settings& settings) {
    groups_.clear();
    for (const PinSettings& pins : settings.pins) {
        const ClothParameters& parameters = settings.cloths[static_cast<std::size_t>(pins.cloth)];
        const ClothModel model = make_cloth_model(parameters);
        const Points x = make_rest_state(parameters).x;
        Group& group = groups_.emplace_back();
        group.settings = pins;
        group.middle.setZero();
        for (int p = pins.particles.nx; p <= pins.particles.ny; ++p) {
            if (!model.pinned(p)) continue;
            group.particles.push_back(p);
            group.arms.push_back(x.row(p).transpose());
            group.middle += group.arms.back();
        }
        group.middle /= static_cast<Real>(group.particles.size());
        for (Vec3& arm : group.arms) arm -= group.middle;
    }
}

void MovingPins::let_go(std::span<Cloth> cloths) {
    for (const Group& group : groups_) {
        Cloth& cloth = cloths[static_cast<std::size_t>(group.settings.cloth)];
        cloth.energy.touch(cloth.model, cloth.state);
        for (const int p : group.particles) {
            if (p != cloth.grabbed) cloth.state.v.row(p).setZero();
        }
    }
    groups_.clear();
}

bool MovingPins::lead(std::span<Cloth> cloths, Real time, Real h) {
    bool moves = false;
    for (Cloth& cloth : cloths) cloth.pin_speed = 0;
    for (Group& group : groups_) {
        moves = lead(group, cloths[static_cast<std::size_t>(group.settings.cloth)], time, h) || moves;
    }
    return moves;
}

bool MovingPins::lead(Group& group, Cloth& cloth, Real time, Real h) {
    const Pose now(group.settings, time), then(group.settings, time + h);
    const bool goes_on = !(now == then);
    const auto velocity_of = [&](std::size_t k) -> Vec3 {
        const Vec3 here = now.of(group.middle, group.arms[k]);
        const Vec3 back = way_back(here - cloth.state.x.row(group.particles[k]).transpose(), h);
        return goes_on ? Vec3((then.of(group.middle, group.arms[k]) - here) / h + back) : back;
    };
    group.moves = goes_on;
    bool stops = false;
    for (std::size_t k = 0; k < group.particles.size() && !group.moves; ++k) {
        const int p = group.particles[k];
        if (p == cloth.grabbed) continue;
        group.moves = !velocity_of(k).isZero(0);
        stops = stops || !cloth.state.v.row(p).isZero(0);
    }
    if (!group.moves && !stops) return false;

    cloth.energy.touch(cloth.model, cloth.state, EnergyLedger::Since::Pins);
    Real gained = 0;
    for (std::size_t k = 0; k < group.particles.size(); ++k) {
        const int p = group.particles[k];
        if (p == cloth.grabbed) continue;
        const Vec3 velocity = velocity_of(k);
        gained += std::max(velocity.squaredNorm() - cloth.state.v.row(p).squaredNorm(), Real(0));
        cloth.pin_speed = std::max(cloth.pin_speed, velocity.norm());
        cloth.state.v.row(p) = velocity.transpose();
    }
    group.power = power_of(group.particles, cloth);
    cloth.energy.give(static_cast<double>(cloth.model.particle_mass / 2 * gained));
    return group.moves;
}

/// The larger of both ends of the step stands for all of it, as for the hand.
void MovingPins::count_work(std::span<Cloth> cloths, Real h) const {
    for (const Group& group : groups_) {
        if (!group.moves) continue;
        Cloth& cloth = cloths[static_cast<std::size_t>(group.settings.cloth)];
        cloth.energy.give(std::max(group.power, power_of(group.particles, cloth)) * static_cast<double>(h));
    }
}

}  // namespace drape
