#include "drape/sim/simulation.h"

#include <algorithm>
#include <utility>

#include "ball_motion.h"
#include "drape/base/stopwatch.h"
#include "drape/contact/ball_solids.h"
#include "drape/contact/node_contacts.h"
#include "drape/contact/response.h"
#include "drape/integrate/integrator.h"
#include "drape/sim/memory.h"
#include "gusts.h"
#include "run_checks.h"
#include "step_plan.h"
#include "stretch_stage.h"

namespace drape {

/// One step, stage by stage: docs/design.md, "One frame", has them in this order.
void Simulation::step() {
    if (report_.status == Status::Diverged) return;
    begin_step();
    for (int k = 0; k < report_.substeps; ++k) {
        const Substep now = substep(k);
        if (!input(now)) continue;    // asleep
        if (!integrate(now)) return;  // diverged
        limit_stretch(cloths_, report_);
        build(now);
        traverse();
        narrow(now);
        if (!respond(now)) return;  // too fast
    }
    close_report();
    rest();
}

/// Keeps what the picture and a step that fails go back to.
void Simulation::begin_step() {
    report_.times = {};
    report_.solve = {};
    previous_balls_ = balls_;
    previous_solids_ = solids_;
    pins_have_moved_ = false;
    for (Cloth& cloth : cloths_) {
        if (!report_.asleep) cloth.previous = cloth.state;
        cloth.energy.mark();
    }
    if (plan_is_due(settings_.solver, report_)) plan(planned_substeps_);
    const bool touches = report_.contacts > 0 || !ball_contacts_.empty() || self_contact_.is_near();
    const auto meets = [&] {
        return may_cross(settings_, cloths_, balls_) || may_touch(settings_, cloths_, balls_, solids_);
    };
    report_.substeps = substeps_in_contact(settings_, touches || (!report_.asleep && meets()), planned_substeps_);
    if (self_contact_.on())
        report_.substeps = std::max(report_.substeps, substeps_of_motion(cloths_, settings_.solver));
}

void Simulation::plan(int fewest) {
    plan_substeps(cloths_, settings_, fewest, report_);
    planned_substeps_ = report_.substeps;
}

Simulation::Substep Simulation::substep(int number) const {
    const Real h = static_cast<Real>(settings_.solver.dt / report_.substeps);
    return {report_.time + number * static_cast<double>(h), h};
}

/// What moves on its own: hand, balls, solids and pins. Commands were carried out between two steps.
/// @return false while the scene is asleep
bool Simulation::input(const Substep& now) {
    hand_.lead(cloths_, {balls_, solids_, settings_.ground, settings_.contact.thickness}, now.h);
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        if (report_.asleep && !is_led(b)) continue;
        move_ball(settings_.balls[b], steer_, settings_.ground, settings_.contact.thickness, gravity_of(settings_),
                  displacement_share(settings_.solver.integrator), static_cast<Real>(now.time), now.h, balls_[b]);
    }
    move_solids(now);
    stop_balls(now);
    move_pins(now);
    if (led_body_has_moved()) wake();
    return !report_.asleep;
}

/// @return false if the run has come to its end
bool Simulation::integrate(const Substep& now) {
    report_.forget_contacts();
    const Air air = air_at(settings_.wind, now.time);
    look_at_cloths();
    take_pushes(now);
    for (Cloth& cloth : cloths_) {
        cloth.model.air = air;
        Stopwatch watch;
        with_memory(settings_, [&] {
            report_.solve += cloth.integrator.step(cloth.model, cloth.state, now.h,
                                                   cloth.energy.start_of_step(cloth.model, cloth.state, cloth.held));
        });
        report_.times.step += watch.lap();
        cloth.search.positions_changed();
        if (settings_.wind.on) cloth.energy.give(most_wind_power(cloth.model) * static_cast<double>(now.h));
    }
    hand_.count_work(cloths_, now.h);
    pins_.count_work(cloths_, now.h);
    std::string trouble = check_substep(cloths_, balls_, settings_, now.h, planned_substeps_, report_);
    if (!trouble.empty()) {
        end_with(std::move(trouble));
        return false;
    }
    warm_start();
    return true;
}

/// As contact sees them within this substep.
void Simulation::look_at_cloths() {
    in_contact_.clear();
    for (Cloth& cloth : cloths_) {
        if (report_.substeps > 1) cloth.before = cloth.state.x;
        in_contact_.push_back({cloth.model, start_of_substep(cloth), cloth.state, cloth.contacts});
    }
}

/// Of the substep before.
void Simulation::take_pushes(const Substep& now) {
    const ResponseParameters response = response_of(settings_);
    for (Cloth& cloth : cloths_) {
        cloth.warm_start.take(response, now.h, cloth.model.gravity.norm(), in_contact_, cloth.contacts);
    }
    self_contact_.take_pushes(response, now.h, gravity_of(settings_).norm(), in_contact_);
}

/// Gives the pushes of the substep before.
void Simulation::warm_start() {
    const auto& pairs = self_contact_.warm_start();
    const bool any =
        std::ranges::any_of(cloths_, [](const Cloth& cloth) { return !cloth.warm_start.pushes().empty(); });
    if (!any && pairs.pushes().empty()) return;
    const double balls_before = kinetic_energy(balls_);
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        Cloth& cloth = cloths_[c];
        cloth.energy.before_pushes(cloth.model, cloth.state,
                                   {cloth.warm_start.pushes(), pairs.pushes(), static_cast<int>(c), balls_, true});
    }
    for (const Cloth& cloth : cloths_) cloth.warm_start.give(in_contact_, balls_);
    pairs.give(in_contact_, balls_);
    double free_work = balls_before - kinetic_energy(balls_);
    for (Cloth& cloth : cloths_) enter_pushes(cloth, cloth.warm_start.pushes(), 0, free_work);
}

/// @param contacts that push it
/// @param led_work by balls that nothing pushes, on this cloth [J]
/// @param free_work by all free balls, which the first cloth that touches one enters; 0 after that [J]
void Simulation::enter_pushes(Cloth& cloth, std::span<const Contact> contacts, double led_work, double& free_work) {
    const bool takes = std::ranges::any_of(contacts, [&](const Contact& contact) {
        return !is_plane(contact.ball) && !is_led(static_cast<std::size_t>(contact.ball));
    });
    const double work = led_work + (takes ? free_work : 0);
    if (cloth.energy.after_pushes(cloth.model, cloth.state, work) && takes) free_work = 0;
}

void Simulation::move_pins(const Substep& now) {
    if (pins_.lead(cloths_, static_cast<Real>(now.time), now.h)) pins_have_moved_ = true;
}

void Simulation::build(const Substep& now) {
    if (balls_.empty()) return;
    Stopwatch watch;
    for (Cloth& cloth : cloths_) {
        cloth.search.build(start_of_substep(cloth), cloth.state.x, balls_, settings_.contact);
        if (settings_.contact.continuous == Continuous::Never) {
            mark_crossing(cloth.search.crossing(), now.time, now.h, report_);
        }
    }
    report_.times.build += watch.lap();
}

void Simulation::traverse() {
    Stopwatch watch;
    for (Cloth& cloth : cloths_) report_.traversal += cloth.search.traverse(balls_, settings_.contact.thickness);
    report_.times.traverse += watch.lap();
}

void Simulation::narrow(const Substep& now) {
    const Real thickness = settings_.contact.thickness;
    Stopwatch watch;
    for (Cloth& cloth : cloths_) {
        report_.false_candidates += cloth.search.narrow(start_of_substep(cloth), cloth.state.x, balls_, thickness,
                                                        node_push_speed * now.h, cloth.contacts);
        meet_solids(cloth);
        mark_solid_crossing(cloth, now);
        if (settings_.ground.solid) {
            report_.ground +=
                cloth.search.meet_ground(cloth.state.x, settings_.ground.height, thickness, cloth.contacts);
        }
        cloth.warm_start.carry_over(response_of(settings_), in_contact_, balls_, cloth.contacts);
        report_.contacts += static_cast<std::int64_t>(cloth.contacts.size());
    }
    find_ball_contacts(balls_, settings_.ground, ball_contacts_);
    find_ball_contacts(balls_, solids_, ball_contacts_);
    report_.times.narrow += watch.lap();
    self_contact_.find(response_of(settings_), in_contact_, balls_);
    report_.pairs = static_cast<std::int64_t>(self_contact_.contacts().size());
    report_.times.pairs += watch.lap();
    for (Cloth& cloth : cloths_) {
        report_.false_contacts += cloth.search.false_contacts(cloth.state.x, balls_, thickness);
    }
}

/// @return false if the run has come to its end
bool Simulation::respond(const Substep& now) {
    Stopwatch watch;
    answer(response_of(settings_), now, self_contact_.contacts(), ball_contacts_);
    look_again(now);
    report_.times.respond += watch.lap();
    hold_back();
    enter_warm_start();
    report_.listed_pairs = self_contact_.report().listed;
    report_.between_cloths = self_contact_.report().traversal;
    report_.times.pairs += watch.lap();
    resist_rolling();
    for (Ball& ball : balls_) turn_ball(ball);
    report_.times.respond += watch.lap();
    for (Cloth& cloth : cloths_) {
        const Real missed = cloth.search.missed_penetration(cloth.state.x, balls_, settings_.contact.thickness);
        report_.missed_penetration = std::max(report_.missed_penetration, static_cast<double>(missed));
    }
    if (self_contact_.report().gave_up) end_with(search_trouble(report_));
    return report_.status == Status::Ok;
}

/// Answers the contacts of the cloths, and these with them.
void Simulation::answer(const ResponseParameters& response, const Substep& now, std::span<PairContact> pairs,
                        std::span<BallContact> ball_contacts) {
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        Cloth& cloth = cloths_[c];
        cloth.energy.before_pushes(cloth.model, cloth.state, {cloth.contacts, pairs, static_cast<int>(c), balls_});
    }
    ContactRows* const rows = settings_.solver.kernels == Kernels::Vector ? &contact_rows_ : nullptr;
    ResponseReport left = resolve_contacts(response, now.h, in_contact_, pairs, balls_, ball_contacts, rows);
    double free_work = left.free_ball_work;
    for (Cloth& cloth : cloths_) {
        enter_pushes(cloth, cloth.contacts, work_of_led_balls(cloth.contacts, balls_), free_work);
    }
    report_.penetration = static_cast<double>(left.depth);
    report_.contact_residual = std::max(report_.contact_residual, static_cast<double>(left.residual));
    report_.contact_sweeps += left.sweeps;
}

/// The fail-safe of contact between cloths.
void Simulation::hold_back() {
    if (!self_contact_.would_cross(in_contact_)) return;
    for (Cloth& cloth : cloths_) cloth.energy.before_hold(cloth.model, cloth.state);
    report_.held_back = self_contact_.hold_back(in_contact_);
    for (Cloth& cloth : cloths_) cloth.energy.after_hold(cloth.model, cloth.state);
    report_.penetration = static_cast<double>(depth_left(response_of(settings_), in_contact_, balls_));
}

void Simulation::enter_warm_start() {
    if (!settings_.solver.ledger) return;
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        const int number = static_cast<int>(c);
        cloths_[c].energy.pushed(cloths_[c].warm_start.work(in_contact_, number) +
                                 self_contact_.warm_start().work(in_contact_, number));
    }
}

void Simulation::resist_rolling() {
    const auto resist = [&](Real coefficient, int ball, Real load) {
        if (coefficient > 0) drape::resist_rolling(coefficient, load, balls_[static_cast<std::size_t>(ball)]);
    };
    for (const BallContact& contact : ball_contacts_) {
        if (contact.ball == the_ground) resist(settings_.ground.rolling, contact.first, contact.impulse.normal);
        if (is_solid(contact.ball)) resist(settings_.contact.rolling, contact.first, contact.impulse.normal);
    }
    for (const Cloth& cloth : cloths_) {
        for (const Contact& contact : cloth.contacts) {
            if (!is_plane(contact.ball)) resist(settings_.contact.rolling, contact.ball, contact.impulse.normal);
        }
    }
}

void Simulation::close_report() {
    ++report_.step;
    if (!report_.asleep) measure_stretch(cloths_, settings_.solver.dt, report_);
    if (report_.solve.unconverged > 0) {
        ++report_.unconverged;
        report_.unsolved_by = settings_.solver.integrator;
    }
    report_.time = counted_from_time_ + static_cast<double>(report_.step - counted_from_step_) * settings_.solver.dt;
    steps_wanted_ = std::max(0, steps_wanted_ - 1);
}

void Simulation::rest() {
    if (report_.asleep) return;
    const Real speed = settings_.solver.sleep_speed;
    if (speed == 0 || settings_.wind.on || hand_.holds() || led_body_has_moved()) return sleep_.restart();
    if (sleep_.look(cloths_, balls_, report_.time, settings_.solver)) fall_asleep();
}

bool Simulation::is_led(std::size_t ball) const { return balls_[ball].inverse_mass == 0; }

bool Simulation::led_body_has_moved() const {
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        if (is_led(b) && balls_[b].centre != previous_balls_[b].centre) return true;
    }
    return pins_have_moved_ || !std::ranges::equal(solids_, previous_solids_, {}, &Solid::position, &Solid::position);
}

const Points& Simulation::start_of_substep(const Cloth& cloth) const {
    return report_.substeps > 1 ? cloth.before : cloth.previous.x;
}

/// The last good state stays on show.
void Simulation::end_with(std::string trouble) {
    report_.trouble = std::move(trouble);
    report_.status = Status::Diverged;
    steps_wanted_ = 0;
    for (Cloth& cloth : cloths_) {
        cloth.state = cloth.previous;
        cloth.contacts.clear();
        cloth.search.positions_changed();
        cloth.energy.return_to_mark();
    }
    self_contact_.forget();
    balls_ = previous_balls_;
    solids_ = previous_solids_;
}

void Simulation::fall_asleep() {
    report_.asleep = true;
    for (Cloth& cloth : cloths_) {
        cloth.energy.still(cloth.model, cloth.state);
        cloth.state.v.setZero();
        cloth.previous = cloth.state;
    }
    for (Ball& ball : balls_) {
        ball.velocity.setZero();
        ball.spin.setZero();
        ball.moved.setZero();
        ball.turned.setZero();
    }
    previous_balls_ = balls_;
}

void Simulation::wake() {
    report_.asleep = false;
    sleep_.restart();
}

}  // namespace drape
