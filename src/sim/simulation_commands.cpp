#include <algorithm>
#include <utility>

#include "body_motion.h"
#include "drape/base/input_error.h"
#include "drape/scene/memory.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "drape/sim/snapshot.h"

namespace drape {
namespace {

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;  // Clang 14 does not deduce it yet

bool same_pinned(const Settings& a, const Settings& b) {
    return std::ranges::equal(a.cloths, b.cloths, {}, &ClothParameters::pinned, &ClothParameters::pinned);
}

void stop_pins(Cloth& cloth) {
    for (int p = 0; p < cloth.model.grid.particles(); ++p) {
        if (cloth.model.pinned(p)) cloth.state.v.row(p).setZero();
    }
}

}  // namespace

void Simulation::apply(const Command& command) {
    rethrow_bad_alloc(settings_, [&] { carry_out(command); });
}

void Simulation::carry_out(const Command& command) {
    std::visit(
        Overloaded{[&](const command::Pause&) { paused_ = !paused_, steps_wanted_ = 0; },
                   [&](const command::Step& step) {
                       paused_ = true;
                       steps_wanted_ = report_.status == Status::Ok ? step.count : 0;
                   },
                   [&](const command::Reset&) { restart(); },
                   [&](const command::LoadScene& scene) {
                       Settings settings = load_scene(scene.name);
                       check(settings);
                       static_cast<void>(make_solids(settings.solids));
                       std::optional<StartState> start = find_start(settings);
                       // There may not be memory for the cloths of both
                       cloths_.clear();
                       contact_ = ContactStage();
                       go_on_from({scene.name, std::move(settings), std::move(start)});
                   },
                   [&](const command::Load& snapshot) { go_on_from(read_snapshot(snapshot.file)); },
                   [&](const command::Compare& compare) {
                       if (compare.begins()) restart();
                   },
                   [&](const command::Set& set) {
                       Settings changed = settings_;
                       assign(changed, set.assignment);
                       if (!same_pinned(changed, settings_)) end_pins_without_particles(changed);
                       configure(std::move(changed));
                   },
                   [&](const command::Next& next) { configure(with_next(settings_, next.setting)); },
                   [&](const command::Add& add) { configure(with_added(within_levels(), add.setting, add.amount)); },
                   [&](const command::Steer& steer) {
                       const Real length = steer.direction.norm();
                       steer_ = length > 0 ? Vec3(steer.direction / length) : Vec3(Vec3::Zero());
                       if (length > 0 && !balls_.empty()) move_ball_by(BallMotion::Keys);
                   },
                   [&](const command::Throw& thrown) {
                       move_ball_by(BallMotion::Free);
                       // The hand would draw it back
                       if (hand_.ball() == static_cast<int>(users_ball_)) hand_.release(cloths_);
                       put_ball(users_ball_, thrown.from);
                       balls_[users_ball_].velocity = thrown.velocity;
                       balls_[users_ball_].spin.setZero();
                       wake();
                   },
                   [&](const command::Fall&) { move_ball_by(BallMotion::Free); },
                   [&](const command::Grab& grab) { hand_.grab(grab, cloths_), wake(); },
                   [&](const command::Hold& hold) { hand_.hold(hold, balls_, cloths_), wake(); },
                   [&](const command::Drag& drag) { hand_.drag(drag.target); },
                   [&](const command::Release&) {
                       if (!hand_.holds()) return;
                       hand_.release(cloths_);
                       wake();
                   },
                   [&](const command::Pin& pin) { change_pin(pin); }, [](const command::OfThePicture auto&) {}},
        command);
}

Simulation::Simulation(std::string scene, Settings settings, std::optional<StartState> start)
    : scene_(std::move(scene)), settings_(std::move(settings)), start_(std::move(start)) {
    check(settings_);
    if (!start_) start_ = find_start(settings_);
    solids_ = make_solids(settings_.solids);
    rethrow_bad_alloc(settings_, [&] { restart(); });
}

void Simulation::go_to(const Simulation& moment) {
    const ViewSettings view = settings_.view;
    const bool paused = paused_;
    *this = moment;
    settings_.view = view;
    paused_ = paused;
    steps_wanted_ = 0;
}

std::vector<Command> Simulation::commands_to_let_go() const {
    std::vector<Command> commands;
    if (!steer_.isZero(0)) commands.emplace_back(command::Steer{});
    if (hand_.holds()) commands.emplace_back(command::Release{});
    return commands;
}

void Simulation::restart() {
    if (motion_by_scene_) settings_.balls[users_ball_].motion = *motion_by_scene_;
    motion_by_scene_.reset();
    hand_ = {};
    steer_.setZero();
    steps_wanted_ = 0;
    report_ = {};
    report_.time = start_ ? start_->time : 0;
    counted_from_step_ = 0;
    counted_from_time_ = report_.time;
    sleep_ = {};
    cloths_.clear();
    for (const ClothParameters& parameters : settings_.cloths) {
        Cloth& cloth = cloths_.emplace_back();
        cloth.model = make_cloth_model(parameters);
        cloth.model.gravity = gravity_of(settings_);
        cloth.state = start_ ? start_->states[cloths_.size() - 1] : make_rest_state(parameters);
        stop_pins(cloth);
        cloth.previous = cloth.state;
        cloth.integrator.use(settings_.solver, parameters.particles);
        cloth.energy.restart(cloth.model, cloth.state, settings_.solver.kernels);
        cloth.energy.keep_ledger(settings_.solver.ledger, cloth.model, cloth.state);
    }
    use_pins();
    contact_.use(settings_, cloths_);
    balls_.clear();
    const bool balls_are_known = start_ && !start_->balls.empty();
    for (std::size_t b = 0; b < settings_.balls.size(); ++b) {
        balls_.push_back(make_ball(settings_.balls[b], report_.time, balls_are_known ? &start_->balls[b] : nullptr));
    }
    previous_balls_ = balls_;
    put_solids(settings_.solids, report_.time, solids_);
    previous_solids_ = solids_;
    depth_at_start_ = deepest_particle();
    choose_ball();
    plan(1);
}

/// The window stays as the user has it, whatever is in it.
void Simulation::go_on_from(Simulation&& other) {
    ViewSettings& view = other.settings_.view;
    view.text_scale = settings_.view.text_scale;
    view.controls = settings_.view.controls;
    view.plots = settings_.view.plots;
    other.paused_ = paused_;
    *this = std::move(other);
}

void Simulation::change_pin(const command::Pin& pin) {
    check_particle("pin", pin.cloth, pin.particle, cloths_);
    const auto number = static_cast<std::size_t>(pin.cloth);
    const ClothModel model = make_cloth_model(settings_.cloths[number]);  // in which the hand holds nothing
    Pins pins{Pins::Kind::List, {}};
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p) != (p == pin.particle)) pins.list.push_back(p);
    }
    if (pins.list.empty()) pins.kind = Pins::Kind::None;
    Settings changed = settings_;
    changed.cloths[number].pinned = std::move(pins);
    end_pins_without_particles(changed);
    configure(std::move(changed));
}

void Simulation::configure(Settings settings) {
    check(settings);
    std::optional<std::vector<Solid>> solids;
    if (settings.solids != settings_.solids) solids = make_solids(settings.solids);
    const bool keeps_state = same_start(settings_, settings);
    if (!keeps_state) start_ = find_start(settings);
    const Settings before = std::exchange(settings_, std::move(settings));
    if (solids) {
        solids_ = *std::move(solids);
        put_solids(settings_.solids, report_.time, solids_);
        previous_solids_ = solids_;
        // Nothing that touched a solid where it was does so where it is now
        contact_.forget_bodies([&](int body) { return body >= static_cast<int>(balls_.size()); });
    }
    if (!keeps_state) return restart();
    if (settings_.solver.dt != before.solver.dt) {
        counted_from_step_ = report_.step;
        counted_from_time_ = report_.time;
    }
    for (std::size_t c = 0; c < cloths_.size(); ++c) configure_cloth(c, before);
    contact_.configure(settings_, before, cloths_);
    configure_balls(before);
    if (settings_.pins != before.pins || !same_pinned(settings_, before)) {
        pins_.let_go(cloths_);
        use_pins();
    }
    if (!same_step_plan(settings_, before)) plan(1);
    if (!same_motion(settings_, before)) wake();
}

Settings Simulation::within_levels() const {
    int levels = 0;
    for (const Cloth& cloth : cloths_) levels = std::max(levels, cloth.search.hierarchy().levels());
    Settings settings = settings_;
    if (levels > 0) settings.view.level = std::min(settings.view.level, levels);
    return settings;
}

void Simulation::configure_cloth(std::size_t number, const Settings& before) {
    Cloth& cloth = cloths_[number];
    cloth.energy.touch(cloth.model, cloth.state);
    cloth.energy.use(settings_.solver.kernels);
    cloth.energy.keep_ledger(settings_.solver.ledger, cloth.model, cloth.state);
    if (settings_.cloths[number] != before.cloths[number] || settings_.world != before.world) {
        const std::uint64_t revision = cloth.model.revision;
        cloth.model = make_cloth_model(settings_.cloths[number]);
        cloth.model.gravity = gravity_of(settings_);
        cloth.model.revision = revision + 1;
        hand_.hold_in(number, cloth.model);
        if (settings_.cloths[number].pinned != before.cloths[number].pinned) stop_pins(cloth);
        cloth.energy.restart(cloth.model, cloth.state, settings_.solver.kernels);
    }
    const IntegratorParameters &integrator = settings_.solver, &earlier = before.solver;
    if (integrator != earlier) cloth.integrator.use(integrator, cloth.model.grid);
}

void Simulation::use_pins() {
    pins_.use(settings_);
    for (Cloth& cloth : cloths_) cloth.energy.expect_pins(false);
    for (const PinSettings& pins : settings_.pins)
        cloths_[static_cast<std::size_t>(pins.cloth)].energy.expect_pins(true);
}

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

}  // namespace drape
