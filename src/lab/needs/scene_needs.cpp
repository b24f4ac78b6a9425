#include "needs.h"

#include <algorithm>
#include <cmath>

#include "drape/base/assert.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/stopwatch.h"
#include "drape/model/stretch_limit.h"
#include "drape/sim/simulation.h"
#include "lab/measure/methods.h"

namespace drape {
namespace {

/// A cloth between two of its steps, by the cubic that has its positions and velocities at both.
/// @param s in [0, 1] from `cloth.previous` to `cloth.state`
Points between_steps(const Cloth& cloth, Real s, Real dt) {
    const auto& [x0, v0] = cloth.previous;
    const auto& [x1, v1] = cloth.state;
    const Real r = 1 - s;
    return (1 + 2 * s) * r * r * x0 + s * s * (1 + 2 * r) * x1 + dt * (s * r * r * v0 - s * s * r * v1);
}

/// RMS distance of some points from their centre [m].
double spread(const Points& x) { return position_error(x, x.colwise().mean().replicate(x.rows(), 1)); }

/// The larger of two; what is no number is larger than all, so that it is not missed.
double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

/// By how much two cloths of one grid differ at a moment [m].
double distance(const Points& x, const Points& full, NeedsMeasure measure) {
    if (measure == NeedsMeasure::Positions) return position_error(x, full);
    const Points off = x - full;
    return larger(static_cast<double>(off.colwise().mean().norm()), std::abs(spread(x) - spread(full)));
}

constexpr double safe_part_of_limit = 0.9;

/// Of the error that a scene allows, what may be the full model's own.
constexpr double largest_own_part = 0.25;

}  // namespace

Motion run_to_horizon(const Settings& scene, double cost_limit, const std::optional<StartState>& start_state) {
    Simulation simulation("", scene, start_state);
    const Cloth& cloth = simulation.cloths()[0];
    const StepReport& report = simulation.report();
    const double start = report.time, horizon = static_cast<double>(scene.needs.horizon);
    const double dt = scene.solver.dt;

    Motion motion;
    motion.grid = cloth.model.grid;
    motion.step_over_limit = report.step_limit_ratio;
    double seconds = 0, by_clock = 0;
    while (motion.x.size() < Motion::moments) {
        const double moment = horizon * static_cast<double>(motion.x.size() + 1) / Motion::moments;
        constexpr double rounding = 1e-9;  // of a step
        while (report.time - start < moment - rounding * dt && report.status == Status::Ok) {
            const double before = program_cpu_time();
            Stopwatch watch;
            simulation.step();
            by_clock += watch.lap();
            seconds += program_cpu_time() - before;
            motion.penetration = larger(motion.penetration, report.penetration);
            motion.stretch = larger(motion.stretch, static_cast<double>(largest_stretch(cloth.model, cloth.state.x)));
            // A run that is far too expensive is not worth its first moment
            if (report.step % 32 == 0 && seconds > cost_limit * horizon) {
                motion.given_up = true;
                break;
            }
        }
        motion.time = report.time - start;
        motion.cost = seconds / std::max(motion.time, dt);
        motion.wall = by_clock / std::max(motion.time, dt);
        motion.diverged = report.status == Status::Diverged;
        if (motion.diverged || motion.given_up) return motion;
        const double part = std::clamp(1 - (motion.time - moment) / dt, 0.0, 1.0);
        motion.x.push_back(between_steps(cloth, static_cast<Real>(part), static_cast<Real>(dt)));
    }
    return motion;
}

double motion_error(const Motion& motion, const Motion& full, NeedsMeasure measure, Real side) {
    DRAPE_ASSERT(motion.x.size() == Motion::moments && full.x.size() == Motion::moments);
    double largest = 0;
    for (std::size_t k = 0; k < Motion::moments; ++k) {
        largest = larger(largest, distance(motion.x[k], resampled(full.x[k], full.grid, motion.grid), measure));
    }
    return largest / static_cast<double>(side);
}

std::string percent(double part) { return real_text(100 * part, 3) + " %"; }

bool states_needs(const NeedsSettings& needs) {
    return needs.position_error > 0 || needs.penetration > 0 || needs.stretch > 0 || needs.min_stretch > 0 ||
           needs.diverges;
}

Needs::Needs(Settings scene) : scene_(std::move(scene)), full_(full_model(scene_)) {
    if (!states_needs(scene_.needs)) {
        throw InputError(
            "[needs] states nothing that this scene must show: say position_error (of the cloth's side), penetration, "
            "stretch, min_stretch or diverges");
    }
    if (!states_error()) return;
    motion_ = run_to_horizon(computed_closely(full_, close_step));
    if (motion_->diverged) throw RunError("the full model diverges after " + real_text(motion_->time, 3) + " s");
}

double Needs::error_of(const Motion& motion, const Motion& other) const {
    const ClothParameters& cloth = scene_.cloths[0];
    return motion_error(motion, other, scene_.needs.measure, std::max(cloth.width, cloth.height));
}

Attempt Needs::attempt(const Settings& settings, double cost_limit) const {
    const NeedsSettings& needs = scene_.needs;
    Attempt attempt{.settings = settings};
    // What is no number misses by all
    const auto note = [&attempt](double measured, const std::string& why) {
        const double miss = std::isnan(measured) ? no_bound : measured;
        if (miss > 1 && (miss > attempt.miss || attempt.why.empty())) attempt.why = why;
        attempt.miss = std::max(attempt.miss, miss);
    };
    const auto failed = [&](const std::string& why) {
        note(no_bound, why);
        return attempt;
    };
    const auto at_most = [&note](double measured, Real allowed, const std::string& why) {
        if (allowed > 0) note(measured / static_cast<double>(allowed), why);
    };

    const double part_of_limit = Simulation("", settings).report().step_limit_ratio;
    attempt.beyond_limit = !needs.diverges && part_of_limit > safe_part_of_limit;
    if (attempt.beyond_limit) return failed("step is " + real_text(part_of_limit, 2) + " of its limit");
    const Motion motion = run_to_horizon(settings, cost_limit);
    attempt.cost = motion.cost;
    const std::string when = real_text(motion.time, 3) + " s";
    if (needs.diverges) return motion.diverged ? attempt : failed("has not diverged after " + when);
    if (motion.diverged) return failed("diverged after " + when);
    if (motion.given_up) return failed("more expensive than the cheapest so far");
    if (states_error()) {
        attempt.error = error_of(motion);
        at_most(attempt.error, needs.position_error,
                "error above " + percent(static_cast<double>(needs.position_error)));
    }
    const std::string stretched = "stretched by " + percent(motion.stretch);
    at_most(motion.penetration, needs.penetration, "ball " + real_text(motion.penetration, 3) + " m deep");
    at_most(motion.stretch, needs.stretch, stretched);
    if (needs.min_stretch > 0) {
        const double least = static_cast<double>(needs.min_stretch);
        note(motion.stretch > 0 ? least / motion.stretch : no_bound, stretched + " only");
    }
    return attempt;
}

std::string Needs::check_full_model() const {
    if (!states_error()) return {};
    const NeedsSettings& needs = scene_.needs;
    const Motion coarser = run_to_horizon(computed_closely(full_, 2 * close_step));
    const Simulation begun("", full_);
    const Cloth& cloth = begun.cloths()[0];
    const StartState start{0, {disturbed(cloth.model, cloth.state)}};
    const Motion beside = run_to_horizon(computed_closely(full_, close_step), no_bound, start);
    if (coarser.diverged || beside.diverged) throw RunError("the full model diverges at a step only twice as long");
    const double growth = motion_error(beside, *motion_, NeedsMeasure::Positions, 1) / static_cast<double>(small_error);
    const std::string grows = "a small error grows " + real_text(growth, 2) + " times";
    if (needs.measure == NeedsMeasure::Positions && growth > most_growth) {
        throw InputError("needs.horizon = " + real_text(static_cast<double>(needs.horizon), 3) + " s: up to then " +
                         grows + ": allowed " + real_text(most_growth) +
                         " where positions are compared; say measure = \"centre_and_spread\", or a shorter horizon");
    }
    const double own = larger(error_of(coarser), error_of(beside));
    if (!(own <= largest_own_part * static_cast<double>(needs.position_error))) {
        throw RunError("the full model is known only to " + percent(own) + ": too little for what the scene allows, " +
                       percent(static_cast<double>(needs.position_error)));
    }
    return "It is known to " + percent(own) + ", by its motion at twice the step and from a start that is " +
           real_text(static_cast<double>(small_error)) + " m off; " + grows + ".\n";
}

}  // namespace drape
