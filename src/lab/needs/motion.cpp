#include "needs.h"

#include <algorithm>
#include <cmath>

#include "drape/base/assert.h"
#include "drape/base/stopwatch.h"
#include "drape/model/energy.h"
#include "drape/sim/simulation.h"
#include "lab/measure/states.h"
#include "lab/measure/statistics.h"

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
double spread(const Points& x) {
    const Points from_centre = x.rowwise() - x.colwise().mean();
    return std::sqrt(static_cast<double>(from_centre.squaredNorm()) / static_cast<double>(x.rows()));
}

/// By how much two cloths of one grid differ at a moment [m].
double distance(const Points& x, const Points& full, NeedsMeasure measure) {
    if (measure == NeedsMeasure::Positions) return position_error(x, full, 1);
    const Points off = x - full;
    return larger(static_cast<double>(off.colwise().mean().norm()), std::abs(spread(x) - spread(full)));
}

}  // namespace

double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

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

}  // namespace drape
