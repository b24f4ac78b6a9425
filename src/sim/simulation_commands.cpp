#include <algorithm>
#include <cmath>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/sim/scene.h"
#include "drape/sim/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

/// How fast the hand pulls, and the time in which it closes a small gap.
constexpr Real hand_speed = 3;         // m/s
constexpr Real hand_lag = Real(0.03);  // s

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};

Ball make_ball(const BallSettings& settings) {
    Ball ball{.centre = settings.position, .radius = settings.radius, .velocity = settings.velocity};
    if (settings.motion == BallMotion::Path) ball.centre = settings.path.front().centre;
    return ball;
}

/// The settings that the motion follows from: what is left out shows or finds the same motion.
Settings laws_of(Settings settings) {
    const ContactSettings defaults;
    settings.title.clear();
    settings.view = {};
    settings.needs = {};
    settings.solver.on_unstable = {};
    settings.solver.threads = {};
    settings.contact.volume = defaults.volume;
    settings.contact.update = defaults.update;
    settings.contact.leaf_cells = defaults.leaf_cells;
    settings.contact.sphere_fit = defaults.sphere_fit;
    settings.contact.coherence = defaults.coherence;
    return settings;
}

/// False if cloths and balls move alike under both.
bool move_otherwise(const Settings& a, const Settings& b) {
    const Settings first = laws_of(a), second = laws_of(b);
    return first.cloths != second.cloths || first.balls != second.balls || first.solver != second.solver ||
           first.contact != second.contact || first.wind != second.wind;
}

/// True if the cloths start from other places or have other particles, so that a state cannot be kept.
bool starts_differently(const ClothParameters& a, const ClothParameters& b) {
    return a.particles != b.particles || a.width != b.width || a.height != b.height || a.plane != b.plane ||
           a.origin() != b.origin() || a.pinned != b.pinned;
}

}  // namespace

void Simulation::apply(const Command& command) {
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
    counted_from_step_ = 0;
    counted_from_time_ = 0;
    cloths_.clear();
    for (const ClothParameters& parameters : settings_.cloths) {
        Cloth& cloth = cloths_.emplace_back();
        cloth.model = make_cloth_model(parameters);
        cloth.state = make_rest_state(parameters);
        cloth.previous = cloth.state;
        cloth.integrator = make_integrator(integrator_of(settings_.solver), parameters.particles);
        cloth.separation = Separation(parameters.particles);
        use_broad_phase(cloth);
        cloth.contacts.reserve(static_cast<std::size_t>(parameters.particles.triangles()));
    }
    balls_.clear();
    for (const BallSettings& ball : settings_.balls) balls_.push_back(make_ball(ball));
    previous_balls_ = balls_;
}

void Simulation::load(const std::string& scene) {
    Settings settings = load_scene(scene);
    check(settings);
    scene_ = scene;
    settings_ = std::move(settings);
    restart();
}

void Simulation::configure(Settings settings) {
    check(settings);
    const Settings before = std::exchange(settings_, std::move(settings));
    if (!std::equal(before.cloths.begin(), before.cloths.end(), settings_.cloths.begin(), settings_.cloths.end(),
                    [](const auto& a, const auto& b) { return !starts_differently(a, b); })) {
        restart();
        return;
    }
    if (settings_.solver.dt != before.solver.dt) {
        counted_from_step_ = report_.step;
        counted_from_time_ = report_.time;
    }
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        Cloth& cloth = cloths_[c];
        if (settings_.cloths[c] != before.cloths[c]) {
            const std::uint64_t revision = cloth.model.revision;
            cloth.model = make_cloth_model(settings_.cloths[c]);
            cloth.model.revision = revision + 1;
            if (hand_ && hand_->cloth == static_cast<int>(c)) cloth.model.hold(hand_->particle, true);
        }
        if (integrator_of(settings_.solver) != integrator_of(before.solver)) {
            cloth.integrator = make_integrator(integrator_of(settings_.solver), cloth.model.grid);
        }
        if (broad_phase_of(settings_.contact) != broad_phase_of(before.contact)) {
            use_broad_phase(cloth);
        }
    }
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        const BallSettings &now = settings_.balls[b], &then = before.balls[b];
        balls_[b].radius = now.radius;
        if (now.position != then.position) balls_[b].centre = now.position;
        if (now.velocity != then.velocity) balls_[b].velocity = now.velocity;
    }
    if (move_otherwise(before, settings_)) wake();
    if (settings_.view.bounds && !before.view.bounds) show_present_bounds();
}

void Simulation::use_broad_phase(Cloth& cloth) {
    const BroadPhaseParameters parameters = broad_phase_of(settings_.contact);
    cloth.broad_phase = make_broad_phase(parameters, cloth.model.grid);
    build(cloth);
    cloth.audit.reset();
    if (!parameters.search.none()) cloth.audit.emplace(cloth.model.grid);
}

void Simulation::show_present_bounds() {
    for (Cloth& cloth : cloths_) {
        if (cloth.tree_is_fresh) continue;
        build(cloth);
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
    cloth.state.v.row(hand_->particle) = velocity.transpose();
}

}  // namespace drape
