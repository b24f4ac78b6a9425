#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "body_motion.h"
#include "drape/base/numbers.h"
#include "drape/bounds/aabb.h"
#include "drape/contact/response.h"
#include "drape/integrate/stability.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

/// Of its limit, that a substep is to stay under.
constexpr Real safe_part = Real(0.9);

/// The most substeps of a step because cloth moves fast.
constexpr double max_for_motion = 32;

/// And because balls are, or cloth near them. What is faster than that has planes of the start of the substep.
constexpr double max_for_balls = 128;

/// From one plan to the next [s].
constexpr double search_pause = 0.25;

/// `solver.dt` [s].
double shortest_that_may_be_set() { return find_setting("solver.dt").range.low; }

StepLimit shortest_limit(std::span<const Cloth> cloths, const Settings& settings) {
    const SolverSettings& solver = settings.solver;
    StepLimit shortest{.step = std::numeric_limits<Real>::infinity()};
    for (const Cloth& cloth : cloths) {
        ClothModel model = cloth.model;
        model.air = strongest_air(settings.wind);
        const StepLimit one = predicted_limit(model, cloth.state, solver.integrator, solver.kernels);
        if (one.step < shortest.step) shortest = one;
    }
    return shortest;
}

/// The longest stable substep of the penalty where it pushes a particle.
struct PenaltyLimit {
    double step;  ///< [s]
    Real mass;    ///< that it pushes: the particle's, less where a free ball gives way [kg]
};

/// None where nothing pushes by a penalty.
std::optional<PenaltyLimit> penalty_limit(const Settings& settings, const ClothModel& model) {
    const ContactSettings& contact = settings.contact;
    const bool has_bodies = !settings.balls.empty() || !settings.solids.empty();
    if (!has_penalties(contact.response) || !(has_bodies || settings.ground.solid)) return std::nullopt;
    // The stiffest damper is where least bounces
    Real restitution = has_bodies ? contact.restitution : Real(1);
    if (settings.ground.solid) restitution = std::min(restitution, settings.ground.restitution);
    Real of_lightest = 0;  // free ball [1/kg]
    for (const BallSettings& ball : settings.balls) of_lightest = std::max(of_lightest, inverse_mass_of(ball));
    const Real mass = 1 / (1 / model.particle_mass + of_lightest);
    const Real factor = displacement_factor(settings.solver.integrator);
    return PenaltyLimit{static_cast<double>(penalty_step_limit(contact.stiffness, restitution, 1 / mass, factor)),
                        mass};
}

/// In how many substeps a step is made: as planned, or more under an implicit method while cloth or balls touch. Where
/// the response has penalties they always may: at the end of a long step one is pressed in so deep that it throws off
/// what has just touched it.
int substeps_in_contact(const Settings& settings, bool may_touch, int planned) {
    const SolverSettings& solver = settings.solver;
    if (!may_touch || has_step_limit(solver.integrator)) return planned;
    const double wanted = std::ceil(solver.dt / settings.contact.longest_step * (1 - 1e-12));
    return std::max(planned, static_cast<int>(std::min(wanted, Simulation::max_substeps)));
}

/// How many substeps a step needs for no ball and no particle near it to come nearer to each other within one than half
/// the ball's radius, by their speeds at its start and gravity; at most 128. What else forces add within the step is
/// not foreseen, but the hand is, and the keys are. 1 where `contact.continuous` is false.
/// @par Cost O(particles), and O(particles) more for each ball that fast cloth may come to
int substeps_of_balls(const Settings& settings, std::span<const Cloth> cloths, std::span<const Ball> balls, int held) {
    if (balls.empty() || settings.contact.continuous == Continuous::Never) return 1;
    const auto dt = static_cast<Real>(settings.solver.dt);
    const Real of_gravity = gravity_of(settings).norm() * dt;
    double halves = 1;
    for (const Cloth& cloth : cloths) {
        const Points &x = cloth.state.x, &v = cloth.state.v;
        const Aabb box{x.colwise().minCoeff(), x.colwise().maxCoeff()};
        const Real speed = std::sqrt(v.rowwise().squaredNorm().maxCoeff());
        // So far from a particle the cells beside it may be, though they are drawn out to twice their size
        const Real cell = cloth.model.hx + cloth.model.hy;
        for (std::size_t b = 0; b < balls.size(); ++b) {
            const Ball& ball = balls[b];
            const Real of_keys = settings.balls[b].motion == BallMotion::Keys ? settings.balls[b].speed : Real(0);
            const bool by_hand = static_cast<int>(b) == held && moves_by_hand(settings.balls[b]);
            const Real of_hand = by_hand ? hand_speed : Real(0);
            const Real own = std::max({ball.velocity.norm(), of_keys, of_hand});
            const Real radius = ball.radius + settings.contact.thickness;
            const auto way = [&](Real of_cloth) { return (own + of_cloth + of_gravity) * dt; };
            if (2 * way(speed) <= radius || !Aabb{ball.centre, ball.centre}.comes_within(box, radius + way(speed)))
                continue;
            for (Eigen::Index p = 0; p < x.rows(); ++p) {
                const Real moved = way(v.row(p).norm());
                const bool meets = (x.row(p).transpose() - ball.centre).norm() <= radius + cell + moved;
                if (meets) halves = std::max(halves, static_cast<double>(2 * moved / radius));
            }
        }
    }
    return static_cast<int>(std::ceil(std::min(halves, max_for_balls)));
}

/// In how many substeps a step is made where cloths meet themselves and each other: in none of them a particle goes
/// farther than half of what particles are apart at rest, but for what all move by together. What is longer would bring
/// every neighbour near. By the velocities at its start, and at most 32.
int substeps_of_motion(std::span<const Cloth> cloths, const SolverSettings& solver) {
    Vec3 sum = Vec3::Zero();
    Eigen::Index particles = 0;
    for (const Cloth& cloth : cloths) {
        sum += cloth.state.v.colwise().sum().transpose();
        particles += cloth.state.v.rows();
    }
    const Vec3 mean = sum / static_cast<Real>(particles);
    Real most = 0;
    for (const Cloth& cloth : cloths) {
        const auto along = [&](int axis) { return (cloth.state.v.col(axis).array() - mean[axis]).square(); };
        const Real speed = std::sqrt((along(0) + along(1) + along(2)).maxCoeff());
        most = std::max(most, 2 * speed / std::min(cloth.model.hx, cloth.model.hy));
    }
    return static_cast<int>(std::clamp(std::ceil(solver.dt * static_cast<double>(most)), 1.0, max_for_motion));
}

}  // namespace

/// Predicts the longest stable substep and says in the report how near to it a substep is, and in how many of them a
/// step is made: under `on_unstable = substep` as many as the limit asks for, else `fewest`.
/// @par Cost that of `predicted_limit` for each cloth; allocates
void Simulation::plan(int fewest) {
    const SolverSettings& solver = settings_.solver;
    const StepLimit shortest = shortest_limit(cloths_, settings_);
    const Real limit = shortest.step;
    report_.limit_is_lower_bound = shortest.at_least;
    // Where no step is short enough, substeps do not help
    const bool bounded = limit > 0 && std::isfinite(limit);
    const double wanted = bounded ? std::ceil(solver.dt / static_cast<double>(safe_part * limit)) : 1;
    const bool divides = solver.on_unstable == OnUnstable::Substep && wanted <= max_substeps;
    planned_substeps_ = divides ? std::max(static_cast<int>(wanted), fewest) : fewest;
    report_.substeps = planned_substeps_;
    const Real substep = static_cast<Real>(solver.dt / planned_substeps_);
    report_.step_limit_ratio = std::isfinite(limit) ? static_cast<double>(substep / limit) : 0;
}

/// Decides the substeps of the step that begins. Now and then it is time to plan again: springs that are drawn out or
/// pushed together vibrate faster than at the start. Substeps then only become more: a symplectic method whose step
/// changes to and fro gains energy.
void Simulation::plan_step() {
    const SolverSettings& solver = settings_.solver;
    if (solver.on_unstable == OnUnstable::Substep && !report_.asleep && report_.step > 0) {
        const auto between = static_cast<std::int64_t>(std::ceil(search_pause / solver.dt));
        if (report_.step % between == 0) plan(planned_substeps_);
    }
    const bool touches = report_.contacts > 0 || contact_.is_near();
    const int of_balls = report_.asleep ? 1 : substeps_of_balls(settings_, cloths_, balls_, hand_.ball());
    const bool may_touch = of_balls > 1 || touches || (!report_.asleep && has_penalties(settings_.contact.response));
    report_.substeps = std::max(of_balls, substeps_in_contact(settings_, may_touch, planned_substeps_));
    if (contact_.self().on()) report_.substeps = std::max(report_.substeps, substeps_of_motion(cloths_, solver));
}

double Simulation::longest_step() const {
    constexpr double none = std::numeric_limits<double>::infinity();
    const double ratio = report_.step_limit_ratio;
    double longest = ratio > 0 ? settings_.solver.dt / planned_substeps_ / ratio : none;
    // Under an implicit method contact has substeps of its own
    const double in_contact = has_step_limit(settings_.solver.integrator) ? none : settings_.contact.longest_step;
    for (const Cloth& cloth : cloths_) {
        const std::optional<PenaltyLimit> penalty = penalty_limit(settings_, cloth.model);
        if (penalty && penalty->step < in_contact) longest = std::min(longest, penalty->step);
    }
    return 0.89 * longest < shortest_that_may_be_set() ? 0 : longest;  // 0.9 of it is what is offered
}

std::string Simulation::limit_advice() const {
    const double longest = longest_step();
    // Not counted those because balls or cloth are fast: what diverges is
    const int substeps = std::min(report_.substeps, substeps_in_contact(settings_, true, planned_substeps_));
    const double substep = settings_.solver.dt / substeps;
    if (longest <= 0) {
        return "No time step of " + std::string(name_of(settings_.solver.integrator)) +
               " that may be set is stable here: more damping, more mass or softer springs" +
               (penalty_limit(settings_, cloths_[0].model) ? ", contact.stiffness included, help. " : " help. ");
    }
    if (!(substep > longest)) return {};
    const std::string ratio = real_text(substep / longest, 3), limit = real_text(1e3 * longest, 3) + " ms. ";
    if (report_.limit_is_lower_bound) return "Time step is up to " + ratio + " x the limit, which is at least " + limit;
    return "Time step is " + ratio + " x the limit of " + limit;
}

std::string Simulation::penalty_limit_warning() const {
    const double substep = settings_.solver.dt / substeps_in_contact(settings_, true, planned_substeps_);
    for (const Cloth& cloth : cloths_) {
        const std::optional<PenaltyLimit> limit = penalty_limit(settings_, cloth.model);
        if (!limit || !(substep / limit->step > 1)) continue;
        return "in contact a substep of " + real_text(substep, 4) + " s is " + real_text(substep / limit->step, 3) +
               " times the step limit of the penalty, contact.stiffness = " +
               real_text(static_cast<double>(settings_.contact.stiffness), 4) + " N/m on " +
               real_text(static_cast<double>(1e3 * limit->mass), 3) + " g";
    }
    return {};
}

std::string Simulation::step_limit_warning() const {
    const SolverSettings& solver = settings_.solver;
    if (!(report_.step_limit_ratio > 1)) return {};
    const std::string method(name_of(solver.integrator));
    const std::string step = "solver.dt = " + real_text(solver.dt, 4) + " s";
    if (!std::isfinite(report_.step_limit_ratio)) {
        const bool sure = !report_.limit_is_lower_bound;
        return step + ": " + method + (sure ? " has no stable step" : " has no step that is sure to be stable") +
               " on this cloth";
    }
    const bool substeps_exhausted = solver.on_unstable == OnUnstable::Substep;
    const double ratio = report_.step_limit_ratio * planned_substeps_;
    const std::string limit = real_text(solver.dt / ratio, 3);
    return step + " is " + (report_.limit_is_lower_bound ? "up to " : "") + real_text(ratio, 3) +
           " times the stability limit of " + method + " on this cloth" +
           (report_.limit_is_lower_bound ? ", which is at least " + limit + " s" : "") +
           (substeps_exhausted ? ", too long to be divided into substeps" : "") +
           (solver.dt / ratio < shortest_that_may_be_set() ? ", and no step that may be set is short enough" : "");
}

}  // namespace drape
