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
#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "lab/needs/configurations.h"
#include "rest_run.h"

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

Row run_to_rest(const std::string& scene, Settings settings, double seconds) {
    SolverSettings watched = settings.solver;
    settings.solver.sleep_speed = 0;
    Simulation simulation(scene, std::move(settings));
    SleepWatch watch;
    RecentSpeed speed(watched.dt);
    const StepReport& report = simulation.report();
    Row row{{"step_s", watched.dt}, {"end", "awake"}};
    for (double end = seconds; report.time < end;) {
        simulation.step();
        if (report.status == Status::Diverged) return {{"step_s", watched.dt}, {"end", "diverged"}};
        speed.look(simulation.cloths());
        const bool was_awake = row.word("end") == "awake";
        if (!was_awake || !watch.look(simulation.cloths(), simulation.balls(), report.time, watched)) continue;
        row.set({{"end", "asleep"}, {"asleep_s", report.time}, {"speed_before_m_per_s", speed.rms()}});
        end = report.time + after_sleep;
    }
    row.set("speed_after_m_per_s", speed.rms());
    return row;
}

Row watch_drift(const std::string& scene, Settings settings, double settle, double seconds) {
    settings.solver.sleep_speed = 0;
    const double step = settings.solver.dt;
    Simulation simulation(scene, std::move(settings));
    RecentSpeed speed(step);
    double drift = 0;
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
        drift = std::max(drift, static_cast<double>(moved.rowwise().norm().maxCoeff()));
    }
    if (simulation.report().status == Status::Diverged) return {{"end", "diverged"}};
    return {{"end", "awake"}, {"drift_m", drift}, {"speed_after_m_per_s", speed.rms()}};
}

namespace {

constexpr double longest_rest_run = 15;
constexpr int quick_particles = 9;

Row row_of(const char* part, const RestCase& one) {
    return {{"part", part}, {"scene", one.scene}, {"response", one.response}, {"integrator", one.integrator}};
}

/// How a scene by one integrator with one response comes to rest.
Rows run_rest_case(const RestCase& one, bool quick) {
    Row row = row_of("rest", one);
    row.set("end", "no_stable_step");
    const Settings settings = rest_settings(one, quick ? quick_particles : 0);
    if (settings.solver.dt > 0) row.set(run_to_rest(one.scene, settings, longest_rest_run));
    return {row};
}

/// One integrator at one step, watched for a time.
struct DriftCase {
    IntegratorKind integrator{};
    double step = 0;     ///< [s]
    double seconds = 0;  ///< simulated, after `settle`
};

/// After so long everything rests that is going to [s].
constexpr double settle = 8;

/// How it then creeps.
Rows run_drift_case(const DriftCase& one, bool quick) {
    const RestCase drop{"drop", one.integrator, ResponseKind::Projection};
    Settings settings = rest_settings(drop, quick ? quick_particles : 0);
    settings.solver.dt = one.step;
    Row row = row_of("drift", drop);
    row.set({{"step_s", one.step}, {"watched_s", one.seconds}});
    row.set(watch_drift(drop.scene, settings, settle, one.seconds));
    return {row};
}

/// Every method by the longest of its steps, then by shorter ones, down to a tenth of a millisecond; then for ten
/// minutes by each of these, which takes hours, and a day for the shortest.
std::vector<DriftCase> drift_list(bool quick) {
    constexpr double shipped = 3.125e-4, ten_minutes = 600;
    constexpr std::pair<double, double> watches[] = {
        {long_step, 6}, {1e-3, 4}, {1e-4, 2}, {long_step, ten_minutes}, {1e-3, ten_minutes}, {1e-4, ten_minutes}};
    std::vector<DriftCase> all;
    for (const auto& [step, seconds] : watches) {
        for (const IntegratorKind integrator : values_of<IntegratorKind>()) {
            if (integrator == IntegratorKind::ExplicitEuler) continue;  // no step of it is stable there
            const double longest = has_step_limit(integrator) ? shipped : long_step;
            if (step == long_step || step <= longest) all.push_back({integrator, std::min(step, longest), seconds});
        }
    }
    if (quick) {
        std::erase_if(all, [](const DriftCase& one) { return one.step < shipped || one.seconds == ten_minutes; });
        for (DriftCase& one : all) one.seconds /= 3;
    }
    return all;
}

ExperimentCases rest_cases(bool quick) {
    return cases_over(
        [=](ResponseKind response, const char* scene, IntegratorKind integrator) {
            return run_rest_case({scene, integrator, response}, quick);
        },
        quick ? std::vector{ResponseKind::Projection} : values_of<ResponseKind>(), std::vector{"drop", "trampoline"},
        values_of<IntegratorKind>());
}

ExperimentCases drift_cases(bool quick) {
    return cases_over([=](const DriftCase& one) { return run_drift_case(one, quick); }, drift_list(quick));
}

}  // namespace

Experiment rest_experiment() {
    return {"rest",
            "do cloth and ball come to rest under every integrator and response, and stay there?",
            3,
            {word_column("part", {"rest", "drift"}), word_column("scene", {"drop", "trampoline"}),
             name_column<ResponseKind>("response"), name_column<IntegratorKind>("integrator"),
             positive_column("step_s").or_nan(), word_column("end", {"asleep", "awake", "diverged", "no_stable_step"}),
             positive_column("asleep_s").or_nan(), number_column("speed_before_m_per_s").or_nan(),
             number_column("speed_after_m_per_s").or_nan(), positive_column("watched_s").or_nan(),
             number_column("drift_m").or_nan()},
            {{"part", "scene", "response", "integrator", "end"},
             {"step_s", "asleep_s", "speed_before_m_per_s", "speed_after_m_per_s", "watched_s", "drift_m"}},
            {{"rest", rest_cases, {}}, {"drift", drift_cases, {}}}};
}

}  // namespace drape
