#include "rest_run.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <span>
#include <utility>

#include "drape/integrate/stability.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "drape/sim/sleep_watch.h"
#include "lab/needs/configurations.h"

namespace drape {
namespace {

constexpr double safe_part = 0.9, after_sleep = 2;

/// `rms_motion` of the last half second, in the mean square.
class RecentSpeed {
public:
    explicit RecentSpeed(double step)
        : step_(step), steps_(static_cast<std::size_t>(std::max(1.0, std::round(RestWatch::duration / step)))) {}

    void look(std::span<const Cloth> cloths) {
        const double speed = rms_motion(cloths, step_);
        squares_.push_back(speed * speed);
        if (squares_.size() > steps_) squares_.pop_front();
    }
    [[nodiscard]] double rms() const {
        return std::sqrt(std::accumulate(squares_.begin(), squares_.end(), 0.0) / static_cast<double>(squares_.size()));
    }

private:
    double step_;
    std::size_t steps_;
    std::deque<double> squares_;
};

}  // namespace

Settings rest_settings(const RestCase& one, int particles) {
    Settings settings = load_scene(one.scene);
    settings.contact.self = false;
    if (particles > 0) settings = on_grid(std::move(settings), {particles, particles});
    settings.solver.integrator = one.integrator;
    settings.contact.response = one.response;
    if (!has_step_limit(one.integrator)) settings.solver.dt = long_step;
    const double shortest = settings.solver.dt / 64;
    const auto is_stable = [&] {
        return settings.solver.dt <= safe_part * Simulation(one.scene, settings).longest_step();
    };
    while (settings.solver.dt >= shortest && !is_stable()) settings.solver.dt /= 2;
    if (settings.solver.dt < shortest) settings.solver.dt = 0;
    return settings;
}

RestRun run_to_rest(const std::string& scene, Settings settings, double seconds) {
    SolverSettings watched = settings.solver;
    settings.solver.sleep_speed = 0;
    Simulation simulation(scene, std::move(settings));
    SleepWatch watch;
    RestRun run{.step = watched.dt};
    RecentSpeed speed(watched.dt);
    const StepReport& report = simulation.report();
    const auto goes_on = [&] {
        const double end = run.asleep < 0 ? seconds : run.asleep + after_sleep;
        return !run.diverged && report.time < end;
    };
    while (goes_on()) {
        simulation.step();
        run.diverged = report.status == Status::Diverged;
        speed.look(simulation.cloths());
        if (run.asleep >= 0 || !watch.look(simulation.cloths(), simulation.balls(), report.time, watched)) continue;
        run.asleep = report.time;
        run.speed_before = speed.rms();
    }
    run.speed_after = speed.rms();
    return run;
}

DriftRun watch_drift(const std::string& scene, Settings settings, double settle, double seconds) {
    settings.solver.sleep_speed = 0;
    const double step = settings.solver.dt;
    Simulation simulation(scene, std::move(settings));
    RecentSpeed speed(step);
    DriftRun run;
    const auto run_until = [&](double time) {
        while (simulation.report().status != Status::Diverged && simulation.report().time < time - step / 2) {
            simulation.step();
            speed.look(simulation.cloths());
        }
    };
    run_until(settle);
    const Points rest = simulation.cloths()[0].state.x;
    for (double watched = 0; watched < seconds;) {
        watched = std::min(watched + 1, seconds);
        run_until(settle + watched);
        const Points moved = simulation.cloths()[0].state.x - rest;
        run.drift = std::max(run.drift, static_cast<double>(moved.rowwise().norm().maxCoeff()));
    }
    run.diverged = simulation.report().status == Status::Diverged;
    run.speed = speed.rms();
    return run;
}

}  // namespace drape
