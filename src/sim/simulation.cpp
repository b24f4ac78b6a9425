#include "drape/sim/simulation.h"

#include <algorithm>
#include <utility>

#include "body_motion.h"
#include "drape/base/stopwatch.h"
#include "drape/integrate/integrator.h"
#include "drape/scene/memory.h"

namespace drape {

/// One step, stage by stage: docs/design.md, "One frame", has them in this order.
void Simulation::step() {
    if (report_.status == Status::Diverged) return;
    begin_step();
    const Real h = static_cast<Real>(settings_.solver.dt / report_.substeps);
    for (int k = 0; k < report_.substeps; ++k) {
        const Substep now{report_.time + k * static_cast<double>(h), h, report_.substeps > 1};
        if (!input(now)) continue;    // asleep
        if (!integrate(now)) return;  // diverged
        limit_stretch();
        contact_.detect(report_);
        contact_.audit_search(report_);
        if (!respond()) return;  // too fast
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
    plan_step();
}

/// What moves on its own: hand, balls, solids and pins. Commands were carried out between two steps.
/// @return false while the scene is asleep
bool Simulation::input(const Substep& now) {
    hand_.lead(cloths_, now.h);
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        if (report_.asleep && balls_[b].inverse_mass != 0) continue;
        move_ball(settings_.balls[b], hand_.velocity_of(b, balls_[b].centre, now.h), steer_, gravity_of(settings_),
                  displacement_factor(settings_.solver.integrator), static_cast<Real>(now.time), now.h, balls_[b]);
    }
    for (std::size_t s = 0; s < solids_.size(); ++s) {
        move_solid(settings_.solids[s], static_cast<Real>(now.time), now.h, solids_[s]);
    }
    pins_have_moved_ = pins_.lead(cloths_, static_cast<Real>(now.time), now.h) || pins_have_moved_;
    if (kinematic_body_has_moved()) wake();
    return !report_.asleep;
}

/// @return false if the run has come to its end
bool Simulation::integrate(const Substep& now) {
    report_.forget_contacts();
    const Air air = air_at(settings_.wind, now.time);
    contact_.begin(settings_, {cloths_, balls_, solids_}, now);
    for (Cloth& cloth : cloths_) {
        cloth.model.air = air;
        Stopwatch watch;
        cloth.energy.start_of_step(cloth.model, cloth.state, cloth.grabbed);
        rethrow_bad_alloc(settings_, [&] { report_.solve += cloth.integrator.step(cloth.model, cloth.state, now.h); });
        report_.times.step += watch.lap();
        cloth.search.positions_changed();
        if (settings_.wind.on) cloth.energy.give(max_wind_power(cloth.model) * static_cast<double>(now.h));
    }
    hand_.count_work(cloths_, now.h);
    pins_.count_work(cloths_, now.h);
    std::string error = check_substep(now.h);
    if (!error.empty()) {
        end_with(std::move(error));
        return false;
    }
    contact_.warm_start();
    return true;
}

/// Shortens structural springs to the limit of each cloth. Its time counts as the integrator's.
void Simulation::limit_stretch() {
    Stopwatch watch;
    for (Cloth& cloth : cloths_) {
        const StretchReport left = cloth.energy.limit_stretch(cloth.model, cloth.grabbed, cloth.state);
        if (left.sweeps > 0) cloth.search.positions_changed();
    }
    report_.times.step += watch.lap();
}

/// @return false if the run has come to its end
bool Simulation::respond() {
    contact_.solve(report_);
    contact_.prevent_crossing(report_);
    contact_.audit_response(report_);
    contact_.end();
    for (Ball& ball : balls_) turn_ball(ball);
    if (contact_.self().report().gave_up) {
        end_with("too much cloth is near, or moves too far, in step " + std::to_string(report_.step + 1) +
                 " for contact.self; reduce solver.dt or contact.thickness");
    }
    return report_.status == Status::Ok;
}

void Simulation::close_report() {
    ++report_.step;
    if (!report_.asleep) measure_stretch();
    if (report_.solve.unconverged > 0) {
        ++report_.unconverged;
        report_.unsolved_by = settings_.solver.integrator;
    }
    report_.time = counted_time();
    steps_wanted_ = std::max(0, steps_wanted_ - 1);
}

double Simulation::counted_time() const {
    return counted_from_time_ + static_cast<double>(report_.step - counted_from_step_) * settings_.solver.dt;
}

void Simulation::rest() {
    if (report_.asleep) return;
    const Real speed = settings_.solver.sleep_speed;
    if (speed == 0 || settings_.wind.on || hand_.holds() || kinematic_body_has_moved()) return sleep_.restart();
    if (sleep_.look(cloths_, balls_, report_.time, speed)) fall_asleep();
}

bool Simulation::kinematic_body_has_moved() const {
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        if (balls_[b].inverse_mass == 0 && balls_[b].centre != previous_balls_[b].centre) return true;
    }
    return pins_have_moved_ || !std::ranges::equal(solids_, previous_solids_, {}, &Solid::position, &Solid::position);
}

/// The last good state stays on show.
void Simulation::end_with(std::string error) {
    report_.error = std::move(error);
    report_.status = Status::Diverged;
    steps_wanted_ = 0;
    for (Cloth& cloth : cloths_) {
        cloth.state = cloth.previous;
        cloth.search.positions_changed();
        cloth.energy.return_to_mark();
    }
    contact_.forget();
    contact_.clear();
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
