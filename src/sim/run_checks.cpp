#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "drape/base/numbers.h"
#include "drape/integrate/stability.h"
#include "drape/model/stencils.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

/// Ratio of a ball's mass to a particle's above which the ball may be the reason that cloth is overstretched.
constexpr Real heavy_mass_ratio = Real(1e5);

/// Excess beyond a small stretch limit, as a fraction of the rest length, from which a spring counts as overstretched.
/// A ball that moves into soft springs stretches them by nearly this much.
constexpr Real large_excess = Real(0.1);

/// What has diverged: one clause that names the first such particle, and which that is; empty while all is well.
struct Divergence {
    std::string clause;
    int particle = -1, other = -1;  ///< `other` is at the other end of the worst of its springs
};

/// How much faster than plausible particles may move. The whip crack of a free corner comes to about five times it.
constexpr Real margin = 20;

/// The fastest that gravity, wind, balls and pins can plausibly make a particle move against the rest [m/s].
Real plausible_speed(const Cloth& cloth, std::span<const Ball> balls, const Settings& settings) {
    const ClothModel& model = cloth.model;
    const Real height = model.hx * static_cast<Real>(model.grid.nx) + model.hy * static_cast<Real>(model.grid.ny);
    Real speed = std::sqrt(2 * gravity_scale(model) * height) + settings.wind.velocity.norm() + cloth.pin_speed;
    for (const Ball& ball : balls) speed += ball.velocity.norm();
    return speed;
}

/// Names a particle, and of its springs the one that is the farthest from its rest length, or one without a length.
Divergence diverged_at(const Cloth& cloth, Eigen::Index particle, const std::string& how) {
    const ClothModel& model = cloth.model;
    const Points& x = cloth.state.x;
    const int p = static_cast<int>(particle), columns = model.grid.nx;
    Divergence found{"particle " + std::to_string(p) + " (column " + std::to_string(p % columns) + ", row " +
                         std::to_string(p / columns) + ") " + how,
                     p};
    Real worst = -1;
    std::string text;
    for_each_spring_at(model, p, [&](const SpringStencil& springs, int other) {
        const Real ratio = (x.row(p) - x.row(other)).norm() / springs.rest_length;
        const Real off = std::isfinite(ratio) ? std::abs(ratio - 1) : std::numeric_limits<Real>::infinity();
        if (springs.law == SpringLaw{} || !(off > worst)) return;
        worst = off;
        found.other = other;
        text = ", its " + std::string(springs.kind()) + " spring to " + std::to_string(other) +
               (std::isfinite(ratio) ? " at " + real_text(static_cast<double>(ratio), 3) + " x its rest length" : "");
    });
    found.clause += text;
    return found;
}

/// What shows that the last step has diverged: a number that is no longer finite, or particles that move against
/// one another far faster than gravity, balls, wind and hand could have made them.
/// @param sums of the cloth's state
/// @par Cost O(1) while all is well
Divergence divergence(const Cloth& cloth, const MotionSums& sums, std::span<const Ball> balls,
                      const Settings& settings) {
    const Points &x = cloth.state.x, &v = cloth.state.v;
    const auto n = static_cast<Real>(v.rows());

    // RMS speed against the mean motion: a long free fall is fast, but together
    const Vec3 mean = sums.velocities / n;
    const Real square = sums.squared_speeds / n - mean.squaredNorm();
    const Real limit = margin * plausible_speed(cloth, balls, settings);
    if (square <= limit * limit && sums.positions.allFinite()) return {};

    // Name the first particle that is not finite, else the fastest
    Eigen::Index fastest = 0;
    Real largest = -1;
    for (Eigen::Index p = 0; p < v.rows(); ++p) {
        if (!x.row(p).allFinite() || !v.row(p).allFinite()) return diverged_at(cloth, p, "is no longer finite");
        const Real speed = (v.row(p).transpose() - mean).squaredNorm();
        if (speed > largest) largest = speed, fastest = p;
    }
    return diverged_at(cloth, fastest, "at " + real_text(static_cast<double>(std::sqrt(largest)), 3) + " m/s");
}

std::string solve_error(IntegratorKind integrator, const StepReport& report) {
    const SolveReport& solve = report.solve;
    const std::string method(name_of(integrator)), step = " step " + std::to_string(report.step + 1);
    const std::string tolerance = "tolerance " + real_text(static_cast<double>(solve.tolerance), 3);
    if (solve.gave_up) {
        return method + " did not finish" + step + " within " + std::to_string(max_inner_steps) +
               " inner steps, taken and rejected, at " + tolerance + "; a shorter solver.dt needs fewer";
    }
    return method + " has not solved" + step + ": residual " + real_text(static_cast<double>(solve.residual), 3) +
           ", " + tolerance;
}

std::string unsolved_error(const StepReport& report) {
    return std::string(name_of(report.unsolved_by)) + " has not solved " + std::to_string(report.unconverged) + " of " +
           std::to_string(report.step) + " steps to its tolerance, largest residual " +
           real_text(report.worst_residual, 3);
}

std::string gain_error(const StepReport& report) {
    return std::string(name_of(report.gained_by)) + " has gained " + real_text(report.energy_excess, 3) +
           " J beyond what hand, pins, balls and wind can have put in, seen first in step " +
           std::to_string(report.energy_gain_step);
}

/// With the masses where a ball is heavy_mass_ratio for the cloth: contact, which comes after the limit, then draws it
/// out.
std::string stretch_error(const StepReport& report, std::span<const Cloth> cloths, std::span<const Ball> balls) {
    std::string text = "structural springs were stretched by up to " + real_text(report.worst_stretch_excess, 3) +
                       " of their length beyond cloth.stretch_limit, and far beyond it for " +
                       real_text(report.overstretched, 3) + " s";
    Real lightest = std::numeric_limits<Real>::infinity(), heaviest = 0;
    for (const Cloth& cloth : cloths) lightest = std::min(lightest, cloth.model.particle_mass);
    for (const Ball& ball : balls) {
        if (ball.inverse_mass > 0) heaviest = std::max(heaviest, 1 / ball.inverse_mass);
    }
    if (heaviest > heavy_mass_ratio * lightest) {
        text += "; a ball has " + real_text(static_cast<double>(heaviest / lightest), 2) +
                " times the mass of a particle, which contact with this cloth does not carry";
    }
    return text;
}

/// Clauses with semicolons between, but for those that are empty.
std::string joined(std::initializer_list<std::string> clauses) {
    std::string text;
    for (const std::string& clause : clauses) text += (text.empty() || clause.empty() ? "" : "; ") + clause;
    return text;
}

/// That balls which keys or forces move start where the scene has them, for the state in which the cloths start has
/// none; empty if not so.
std::string ball_start_warning(const Settings& settings, const std::optional<StartState>& start) {
    const bool unknown = !settings.start.empty() && start && start->balls.empty();
    if (!unknown || std::ranges::none_of(settings.balls, moves_by_hand)) return {};
    return "start = " + settings.start + " has no balls: they start where the scene has them";
}

}  // namespace

std::string Simulation::check_substep(Real h) {
    const SolverSettings& solver = settings_.solver;
    const auto residual = static_cast<double>(report_.solve.residual);
    if (!(residual <= report_.worst_residual)) report_.worst_residual = residual;
    if (report_.solve.gave_up) return solve_error(solver.integrator, report_);

    // An explicit step costs little more than the sum over the springs
    const int min_pause = has_step_limit(solver.integrator) ? 32 : 1;
    bool gained = false;
    for (Cloth& cloth : cloths_) {
        const MotionSums sums = sum_motion(cloth.state);
        const Divergence found = divergence(cloth, sums, balls_, settings_);
        if (!found.clause.empty()) {
            report_.failure = {static_cast<int>(&cloth - cloths_.data()), found.particle, found.other};
            return "Diverged after step " + std::to_string(report_.step) + " (" +
                   std::string(name_of(solver.integrator)) + "). " + limit_advice() + "First: " + found.clause;
        }
        cloth.energy.after_integrator(cloth.model, cloth.state, sums, h, min_pause);
        report_.energy_excess = std::max(report_.energy_excess, cloth.energy.watch().excess());
        gained = gained || cloth.energy.watch().gained();
        if (gained && report_.energy_gain_step == 0) {
            report_.energy_gain_step = report_.step + 1;
            report_.gained_by = solver.integrator;
        }
    }
    if (solver.on_unstable != OnUnstable::Stop) return {};
    if (report_.solve.unconverged > 0) return solve_error(solver.integrator, report_);
    return gained ? gain_error(report_) : "";
}

void Simulation::measure_stretch() {
    report_.stretch_excess = 0;
    bool over = false;
    for (const Cloth& cloth : cloths_) {
        const Real excess = stretch_excess(cloth.model, cloth.state.x);
        report_.stretch_excess = std::max(report_.stretch_excess, static_cast<double>(excess));
        over = over || excess > std::max(cloth.model.stretch_limit, large_excess);
    }
    report_.worst_stretch_excess = std::max(report_.worst_stretch_excess, report_.stretch_excess);
    if (over) report_.overstretched += settings_.solver.dt;
}

std::string Simulation::crossing_warning() const {
    const TunnellingRisk& danger = report_.crossing;
    if (danger.starts == 0) return {};
    return "contact.continuous = false: cloth and a ball or a solid approach each other at up to " +
           real_text(danger.speed, 3) + " m/s, and above " + real_text(danger.safe_speed, 3) +
           " m/s one may pass through the other within a step";
}

Real Simulation::deepest_particle() const {
    Real depth = 0;
    for (const Cloth& cloth : cloths_) {
        for (int number = 0; number < cloth.model.grid.particles(); ++number) {
            if (cloth.model.pinned(number)) continue;
            const Vec3 p = cloth.state.x.row(number).transpose();
            for (const Ball& ball : balls_) depth = std::max(depth, ball.radius - (p - ball.centre).norm());
            for (const Solid& solid : solids_) depth = std::max(depth, -solid.distance(p));
            if (settings_.ground.solid) depth = std::max(depth, settings_.ground.height - p.y());
        }
    }
    constexpr auto rounding = Real(1e-6);
    return depth > std::max(settings_.contact.thickness, rounding) ? depth : 0;
}

std::string Simulation::step_warning() const {
    const std::int64_t crossings = contact_.self().crossings_at_start();
    const std::int64_t coincident = contact_.self().coincident_at_start();
    const auto places = [](std::int64_t count) {
        return std::to_string(count) + (count == 1 ? " place" : " places") + " at the start and ";
    };
    // What has diverged says by itself how long its step was
    const bool diverged = report_.failure.particle >= 0;
    return joined(
        {diverged ? "" : step_limit_warning(), diverged ? "" : penalty_limit_warning(),
         crossings > 0 ? "cloth crosses cloth in " + places(crossings) + "may stay crossed" : "",
         coincident > 0 ? "cloth touches cloth at distance 0 in " + places(coincident) + "may cross it; place it apart"
                        : "",
         depth_at_start_ > 0 ? "cloth starts " + real_text(static_cast<double>(depth_at_start_), 3) +
                                   " m deep inside a ball, a solid or the ground, and may be thrown off as it is "
                                   "pushed out"
                             : "",
         ball_start_warning(settings_, start_)});
}

std::string Simulation::run_warning() const {
    return joined({report_.unconverged > 0 ? unsolved_error(report_) : "",
                   is_overstretched(report_) ? stretch_error(report_, cloths_, balls_) : "",
                   report_.energy_gain_step > 0 ? gain_error(report_) : ""});
}

}  // namespace drape
