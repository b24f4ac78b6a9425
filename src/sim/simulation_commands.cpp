#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "ball_motion.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/integrate/stability.h"
#include "drape/sim/memory.h"
#include "drape/sim/scene.h"
#include "drape/sim/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

/// Of its limit, that a part of a step is to stay under, and the most parts that one is made in.
constexpr Real safe_part = Real(0.9);
constexpr double most_substeps = 1000;

/// How fast the hand pulls, and the time in which it closes a small gap.
constexpr Real hand_speed = 3;         // m/s
constexpr Real hand_lag = Real(0.03);  // s

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;  // Clang 14 does not deduce it yet

Ball make_ball(const BallSettings& settings, double time) {
    Ball ball{.centre = settings.position, .radius = settings.radius, .velocity = settings.velocity};
    if (settings.motion == BallMotion::Path) ball.centre = point_on_path(settings.path, static_cast<Real>(time));
    return ball;
}

/// The settings that the motion follows from: what is left out shows or finds the same motion. Under a limited search
/// that is not so of the hierarchy, for then its nodes stand for the cloth.
Settings laws_of(Settings settings, bool limited) {
    const ContactSettings defaults;
    settings.title.clear();
    settings.view = {};
    settings.needs = {};
    if (settings.solver.on_unstable == OnUnstable::Stop) settings.solver.on_unstable = OnUnstable::Warn;
    settings.solver.ledger = {};
    settings.solver.threads = {};
    settings.contact.coherence = defaults.coherence;
    if (limited) return settings;
    settings.contact.volume = defaults.volume;
    settings.contact.update = defaults.update;
    settings.contact.leaf_cells = defaults.leaf_cells;
    settings.contact.sphere_fit = defaults.sphere_fit;
    return settings;
}

/// False if cloths and balls move alike under both.
bool move_otherwise(const Settings& a, const Settings& b) {
    const bool limited = !broad_phase_of(a).search.none() || !broad_phase_of(b).search.none();
    const Settings first = laws_of(a, limited), second = laws_of(b, limited);
    return first.cloths != second.cloths || first.balls != second.balls || first.solver != second.solver ||
           first.contact != second.contact || first.wind != second.wind;
}

/// True if the cloths start from other places or have other particles, so that a state cannot be kept.
bool starts_differently(const ClothParameters& a, const ClothParameters& b) {
    return a.particles != b.particles || a.width != b.width || a.height != b.height || a.plane != b.plane ||
           a.origin() != b.origin() || a.pinned != b.pinned;
}

/// True if another integrator is to be made. Only the methods with a limit share their work among threads; the others
/// keep what they remember.
bool steps_otherwise(const SolverSettings& a, const SolverSettings& b) {
    IntegratorParameters first = integrator_of(a);
    const IntegratorParameters second = integrator_of(b);
    if (!has_step_limit(second.kind)) first.threads = second.threads;
    return first != second;
}

}  // namespace

void Simulation::apply(const Command& command) {
    with_memory(settings_, [&] { carry_out(command); });
}

void Simulation::carry_out(const Command& command) {
    std::visit(Overloaded{[&](const command::Pause&) { paused_ = !paused_, steps_wanted_ = 0; },
                          [&](const command::Step& step) {
                              paused_ = true;
                              steps_wanted_ = report_.status == Status::Ok ? step.count : 0;
                          },
                          [&](const command::Reset&) { restart(); },
                          [&](const command::LoadScene& scene) { load(scene.name); },
                          [&](const command::Set& set) {
                              Settings changed = settings_;
                              assign(changed, set.assignment);
                              configure(std::move(changed));
                          },
                          [&](const command::Next& next) { configure(with_next(settings_, next.setting)); },
                          [&](const command::Add& add) { configure(with_added(settings_, add.setting, add.amount)); },
                          [&](const command::Steer& steer) {
                              const Real length = steer.direction.norm();
                              steer_ = length > 0 ? Vec3(steer.direction / length) : Vec3(Vec3::Zero());
                          },
                          [&](const command::Grab& grabbed) { grab(grabbed); },
                          [&](const command::Drag& drag) {
                              if (hand_) hand_->target = drag.target;
                          },
                          [&](const command::Release&) { release(); }, [](const auto&) {}},
               command);
}

void Simulation::restart() {
    hand_.reset();
    steer_.setZero();
    steps_wanted_ = 0;
    report_ = {};
    report_.time = start_ ? start_->time : 0;
    counted_from_step_ = 0;
    counted_from_time_ = report_.time;
    cloths_.clear();
    for (const ClothParameters& parameters : settings_.cloths) {
        Cloth& cloth = cloths_.emplace_back();
        cloth.model = make_cloth_model(parameters);
        cloth.state = start_ ? start_->states[cloths_.size() - 1] : make_rest_state(parameters);
        for (int p = 0; p < parameters.particles.particles(); ++p) {
            if (cloth.model.pinned(p)) cloth.state.v.row(p).setZero();
        }
        cloth.previous = cloth.state;
        cloth.integrator = make_integrator(integrator_of(settings_.solver), parameters.particles);
        cloth.separation = Separation(parameters.particles, settings_.solver.kernels);
        if (settings_.solver.ledger) cloth.ledger.emplace(cloth.model, cloth.state);
        cloth.energy_watch.restart(cloth.model, cloth.state);
        use_broad_phase(cloth);
        cloth.contacts.reserve(static_cast<std::size_t>(parameters.particles.triangles()));
    }
    balls_.clear();
    for (const BallSettings& ball : settings_.balls) balls_.push_back(make_ball(ball, report_.time));
    previous_balls_ = balls_;
    predict_limit();
}

void Simulation::load(const std::string& scene) {
    Settings settings = load_scene(scene);
    check(settings);
    start_ = find_start(settings);
    scene_ = scene;
    settings_ = std::move(settings);
    restart();
}

void Simulation::configure(Settings settings) {
    check(settings);
    const bool same_places = std::ranges::equal(settings_.cloths, settings.cloths, std::not_fn(starts_differently));
    const bool starts_anew = !same_places || settings.start != settings_.start;
    std::optional<StartState> start = starts_anew ? find_start(settings) : std::nullopt;
    const Settings before = std::exchange(settings_, std::move(settings));
    if (starts_anew) {
        start_ = std::move(start);
        restart();
        return;
    }
    if (settings_.solver.dt != before.solver.dt) {
        counted_from_step_ = report_.step;
        counted_from_time_ = report_.time;
    }
    const bool other_hierarchy = broad_phase_of(settings_) != broad_phase_of(before);
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        Cloth& cloth = cloths_[c];
        cloth.touched = true;
        if (settings_.solver.ledger != before.solver.ledger) {
            cloth.ledger.reset();
            if (settings_.solver.ledger) cloth.ledger.emplace(cloth.model, cloth.state);
        }
        if (settings_.cloths[c] != before.cloths[c]) {
            const std::uint64_t revision = cloth.model.revision;
            cloth.model = make_cloth_model(settings_.cloths[c]);
            cloth.model.revision = revision + 1;
            if (hand_ && hand_->cloth == static_cast<int>(c)) cloth.model.hold(hand_->particle, true);
            cloth.energy_watch.restart(cloth.model, cloth.state);
        }
        if (steps_otherwise(before.solver, settings_.solver)) {
            cloth.integrator = make_integrator(integrator_of(settings_.solver), cloth.model.grid);
        }
        if (other_hierarchy) use_broad_phase(cloth);
    }
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        const BallSettings &now = settings_.balls[b], &then = before.balls[b];
        balls_[b].radius = now.radius;
        if (now.position != then.position) balls_[b].centre = now.position;
        if (now.velocity != then.velocity) balls_[b].velocity = now.velocity;
    }
    const SolverSettings &now = settings_.solver, &then = before.solver;
    if (settings_.cloths != before.cloths || now.integrator != then.integrator || now.dt != then.dt ||
        now.on_unstable != then.on_unstable) {
        predict_limit();
    }
    if (move_otherwise(before, settings_)) wake();
    if (settings_.view.bounds && (other_hierarchy || !before.view.bounds)) show_present_bounds();
}

void Simulation::predict_limit(int fewest_parts) {
    const SolverSettings& solver = settings_.solver;
    StepLimit shortest{.step = std::numeric_limits<Real>::infinity()};
    for (const Cloth& cloth : cloths_) {
        const StepLimit one = predicted_limit(cloth.model, cloth.state, solver.integrator);
        if (one.step < shortest.step) shortest = one;
    }
    const Real limit = shortest.step;
    report_.limit_is_least = shortest.at_least;
    // Where no step is short enough, parts do not help
    const bool bounded = limit > 0 && std::isfinite(limit);
    const double wanted = bounded ? std::ceil(solver.dt / static_cast<double>(safe_part * limit)) : 1;
    const bool divides = solver.on_unstable == OnUnstable::Substep && wanted <= most_substeps;
    report_.substeps = divides ? std::max(static_cast<int>(wanted), fewest_parts) : fewest_parts;
    const Real part = static_cast<Real>(solver.dt / report_.substeps);
    report_.step_over_limit = std::isfinite(limit) ? static_cast<double>(part / limit) : 0;
}

std::string Simulation::step_warning() const {
    if (!(report_.step_over_limit > 1)) return {};
    const SolverSettings& solver = settings_.solver;
    const std::string method(name_of(solver.integrator));
    const std::string step = "solver.dt = " + real_text(solver.dt, 4) + " s";
    if (!std::isfinite(report_.step_over_limit)) {
        const bool sure = !report_.limit_is_least;
        return step + ": " + method + (sure ? " is stable with no step" : " is sure to be stable with no step") +
               " on this cloth";
    }
    const bool in_vain = solver.on_unstable == OnUnstable::Substep;
    const double over = report_.step_over_limit * report_.substeps;
    const std::string limit = real_text(solver.dt / over, 3);
    return step + " is " + (report_.limit_is_least ? "up to " : "") + real_text(over, 3) + " of the limit of " +
           method + " on this cloth" + (report_.limit_is_least ? ", which is at least " + limit + " s" : "") +
           (in_vain ? ", too long to be made in parts" : "");
}

void Simulation::use_broad_phase(Cloth& cloth) {
    const BroadPhaseParameters parameters = broad_phase_of(settings_);
    cloth.broad_phase = make_broad_phase(parameters, cloth.model.grid);
    build(cloth);
    cloth.audit.reset();
    if (!parameters.search.none()) cloth.audit.emplace(cloth.model.grid);
}

void Simulation::show_present_bounds() {
    for (Cloth& cloth : cloths_) {
        if (!cloth.tree_is_fresh) build(cloth);
        for (const Ball& ball : balls_) {
            cloth.broad_phase->query(grown(ball, settings_.contact.thickness), cloth.candidates);
        }
    }
}

void Simulation::grab(const command::Grab& command) {
    if (command.cloth < 0 || command.cloth >= static_cast<int>(cloths_.size())) {
        throw InputError("grab: cloth " + std::to_string(command.cloth) + ": allowed 0 to " +
                         std::to_string(cloths_.size() - 1));
    }
    Cloth& cloth = cloths_[static_cast<std::size_t>(command.cloth)];
    const int particles = cloth.model.grid.particles();
    if (command.particle < 0 || command.particle >= particles) {
        throw InputError("grab: particle " + std::to_string(command.particle) + ": allowed 0 to " +
                         std::to_string(particles - 1));
    }
    release();
    hand_ = Hand{command.cloth, command.particle, cloth.state.x.row(command.particle).transpose(),
                 cloth.model.pinned(command.particle)};
    cloth.model.hold(command.particle, true);
    wake();
}

void Simulation::release() {
    if (!hand_) return;
    Cloth& cloth = cloths_[static_cast<std::size_t>(hand_->cloth)];
    if (hand_->was_pinned) {
        cloth.state.v.row(hand_->particle).setZero();
    } else {
        cloth.model.hold(hand_->particle, false);
    }
    cloth.touched = true;
    hand_.reset();
    wake();
}

void Simulation::move_hand(Real h) {
    if (!hand_) return;
    Cloth& cloth = cloths_[static_cast<std::size_t>(hand_->cloth)];
    const Vec3 here = cloth.state.x.row(hand_->particle).transpose();

    // The hand stays outside the balls, for what it holds cannot be pushed out of them
    Vec3 target = hand_->target;
    for (const Ball& ball : balls_) {
        const Vec3 offset = target - ball.centre;
        const Real reach = ball.radius + settings_.contact.thickness, distance = offset.norm();
        if (distance < reach) target = ball.centre + (distance > 0 ? Vec3(offset / distance) : Vec3(0, 1, 0)) * reach;
    }
    Vec3 velocity = (target - here) / std::max(hand_lag, h);
    const Real speed = velocity.norm();
    if (speed > hand_speed) velocity *= hand_speed / speed;
    const Real gained = velocity.squaredNorm() - cloth.state.v.row(hand_->particle).squaredNorm();
    cloth.energy_watch.give(static_cast<double>(cloth.model.particle_mass / 2 * std::max(gained, Real(0))));
    cloth.state.v.row(hand_->particle) = velocity.transpose();
    cloth.touched = true;
}

double Simulation::present_hand_power() const {
    if (!hand_) return 0;
    const Cloth& cloth = cloths_[static_cast<std::size_t>(hand_->cloth)];
    return hand_power(cloth.model, cloth.state, hand_->particle);
}

/// The larger of both ends of the substep stands for all of it: a spring that is drawn out pulls ever more.
void Simulation::count_hand_work(double power_before, Real h) {
    if (!hand_) return;
    const double power = std::max({power_before, present_hand_power(), 0.0});
    cloths_[static_cast<std::size_t>(hand_->cloth)].energy_watch.give(power * static_cast<double>(h));
}

}  // namespace drape