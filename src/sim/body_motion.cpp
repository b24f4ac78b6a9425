#include "body_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drape/base/assert.h"
#include "drape/base/exact_math.h"
#include "drape/scene/mesh_file.h"
#include "drape/sim/hand.h"

namespace drape {
namespace {

/// The time in which a ball takes on most of the velocity that the keys ask for [s].
constexpr Real steering_lag = Real(0.08);

bool is_closed(const std::vector<PathPoint>& path) { return path.front().centre == path.back().centre; }

/// The tangent at point k: the direction between its neighbours, across the seam of a closed path, zero at open ends.
Vec3 tangent(const std::vector<PathPoint>& path, std::size_t k) {
    const std::size_t last = path.size() - 1;
    if (k > 0 && k < last) {
        return (path[k + 1].centre - path[k - 1].centre) / (path[k + 1].time - path[k - 1].time);
    }
    if (!is_closed(path) || last < 2) return Vec3::Zero();
    const Real span = (path[1].time - path[0].time) + (path[last].time - path[last - 1].time);
    return (path[1].centre - path[last - 1].centre) / span;
}

using Quaternion = Eigen::Quaternion<Real>;

std::shared_ptr<const SolidShape> shape_of(const SolidSettings& settings) {
    switch (settings.shape) {
        case SolidKind::Box:
            return make_box(settings.size);
        case SolidKind::Capsule:
            return make_capsule(settings.radius, settings.length);
        case SolidKind::Mesh:
            return make_mesh_shape(read_mesh(settings.file));
    }
    return nullptr;
}

/// The air with gusts on the mean wind, of their amplitude times a number in [-1, 1].
Air air_in_gusts(const WindSettings& wind, double gusts) {
    constexpr Real air_density = Real(1.225);  // kg/m^3, at 15 degrees Celsius and sea level (ISO 2533)
    if (!wind.on) return {};
    return {wind.velocity * (1 + wind.gust * static_cast<Real>(gusts)), air_density};
}

}  // namespace

Air air_at(const WindSettings& wind, double time) {
    return air_in_gusts(wind, (sine(2.1 * time) + sine(5.3 * time + 1.3)) / 2);
}

Air strongest_air(const WindSettings& wind) { return air_in_gusts(wind, 1); }

Vec3 point_on_path(const std::vector<PathPoint>& path, Real time) {
    DRAPE_ASSERT(path.size() >= 2 && std::ranges::is_sorted(path, {}, &PathPoint::time));
    const Real begin = path.front().time, end = path.back().time;
    if (is_closed(path) && time > end) time = begin + std::fmod(time - begin, end - begin);
    if (time <= begin) return path.front().centre;
    if (time >= end) return path.back().centre;

    // Cubic Hermite between the two points about the time
    const auto next =
        std::upper_bound(path.begin(), path.end(), time, [](Real t, const PathPoint& point) { return t < point.time; });
    const auto k = static_cast<std::size_t>(next - path.begin()) - 1;
    const Real span = path[k + 1].time - path[k].time, s = (time - path[k].time) / span;
    const Real square = s * s, cube = square * s;
    return (2 * cube - 3 * square + 1) * path[k].centre + (cube - 2 * square + s) * span * tangent(path, k) +
           (3 * square - 2 * cube) * path[k + 1].centre + (cube - square) * span * tangent(path, k + 1);
}

Ball make_ball(const BallSettings& settings, double time, const Ball* start) {
    Ball ball = start != nullptr ? *start : Ball{.centre = settings.position, .velocity = settings.velocity};
    ball.radius = settings.radius;
    ball.inverse_mass = inverse_mass_of(settings);
    if (settings.motion == BallMotion::Path) ball.centre = point_on_path(settings.path, static_cast<Real>(time));
    return ball;
}

Real inverse_mass_of(const BallSettings& settings) {
    return settings.motion == BallMotion::Free ? 1 / settings.mass : Real(0);
}

void move_ball(const BallSettings& settings, const std::optional<Vec3>& by_hand, const Vec3& steer, const Vec3& gravity,
               Real displacement_factor, Real time, Real h, Ball& ball) {
    Vec3 start = ball.centre;
    const Real lag = by_hand ? hand_lag : steering_lag;
    switch (by_hand && settings.motion == BallMotion::Free ? BallMotion::Keys : settings.motion) {
        case BallMotion::Keys:
            ball.velocity += std::min(h / lag, Real(1)) * (by_hand.value_or(settings.speed * steer) - ball.velocity);
            ball.centre += h * ball.velocity;
            start = ball.centre - h * ball.velocity;
            break;
        case BallMotion::Path:
            start = point_on_path(settings.path, time);  // wherever a command has put it
            ball.centre = point_on_path(settings.path, time + h);
            ball.velocity = (ball.centre - start) / h;
            break;
        case BallMotion::Still:
            ball.velocity.setZero();
            break;
        case BallMotion::Free:
            ball.velocity += h * gravity;
            ball.centre += h * (ball.velocity - (1 - displacement_factor) * h * gravity);
            break;
    }
    if (ball.inverse_mass == 0) ball.spin.setZero();
    ball.moved = ball.centre - start;
    ball.turned = h * ball.spin;
}

void resist_rolling(Real coefficient, Real load, Ball& ball) {
    const Real spin = ball.spin.norm();
    if (spin == 0) return;
    const Real most = coefficient * ball.radius * load * ball.inverse_inertia();
    ball.spin *= std::max(1 - most / spin, Real(0));
}

Quaternion turn_about(const Vec3& axis, double turns) {
    constexpr double half_turn = std::numbers::pi;
    const double half = turns * half_turn;
    Quaternion turn;
    turn.w() = static_cast<Real>(sine(half + half_turn / 2));
    turn.vec() = static_cast<Real>(sine(half)) * axis;
    return turn.normalized();
}

void turn_ball(Ball& ball) {
    const Vec3& turned = ball.turned;
    if (turned.isZero(0)) return;
    const Quaternion rate(0, turned.x() / 2, turned.y() / 2, turned.z() / 2);
    Quaternion& orientation = ball.orientation;
    orientation.coeffs() += (rate * orientation).coeffs();
    orientation.normalize();
}

std::vector<Solid> make_solids(const std::vector<SolidSettings>& settings) {
    std::vector<Solid> solids;
    for (const SolidSettings& one : settings) {
        Solid& solid = solids.emplace_back();
        solid.shape = shape_of(one);
        solid.orientation = turn_about(one.axis.normalized(), static_cast<double>(one.angle) / 360);
    }
    return solids;
}

void put_solids(const std::vector<SolidSettings>& settings, double time, std::vector<Solid>& solids) {
    for (std::size_t s = 0; s < solids.size(); ++s) {
        const bool on_path = settings[s].motion == SolidMotion::Path;
        solids[s].position = on_path ? point_on_path(settings[s].path, static_cast<Real>(time)) : settings[s].position;
        solids[s].velocity.setZero();
        solids[s].moved.setZero();
    }
}

void move_solid(const SolidSettings& settings, Real time, Real h, Solid& solid) {
    if (settings.motion == SolidMotion::Still) return;
    solid.position = point_on_path(settings.path, time + h);
    solid.moved = solid.position - point_on_path(settings.path, time);
    solid.velocity = solid.moved / h;
}

}  // namespace drape
