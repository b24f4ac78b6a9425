#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "drape/integrate/stability.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "drape/sim/sleep_watch.h"
#include "lab/experiments.h"
#include "lab/needs/needs.h"

namespace drape {
namespace {

/// At which methods without a step limit run [s].
constexpr double long_step = 1.0 / 60;

/// A shipped scene with another integrator and response, that never sleeps. The drag on the whole cloth stays the same.
Settings rest_settings(const char* scene, IntegratorKind integrator, ResponseKind response, bool quick) {
    Settings settings = load_scene(scene);
    if (quick) settings = on_grid(std::move(settings), {9, 9});
    settings.solver.integrator = integrator;
    settings.solver.sleep_speed = 0;
    settings.contact.response = response;
    settings.contact.self = false;
    return settings;
}

/// Steps a simulation up to a time.
/// @param squares of `rms_motion` in each step, of which those of the last half second are kept [m^2/s^2]
/// @return false if it has diverged
bool run_until(Simulation& simulation, double time, std::deque<double>& squares) {
    const double dt = simulation.settings().solver.dt, kept = std::max(1.0, std::round(RestWatch::duration / dt));
    while (simulation.report().time < time - dt / 2) {
        simulation.step();
        const double speed = rms_motion(simulation.cloths(), dt);
        squares.push_back(speed * speed);
        if (static_cast<double>(squares.size()) > kept) squares.pop_front();
        if (simulation.report().status == Status::Diverged) return false;
    }
    return true;
}

double root_mean(const std::deque<double>& squares) {
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(squares.size()));
}

/// Runs a scene until two seconds after it would have fallen asleep, at its own step under a method that has a step
/// limit, else at `long_step`, halved until it is below nine tenths of the limits of method and penalty, to a 64th at
/// least. Speeds are those of the last half second.
Rows run_rest_case(ResponseKind response, const char* scene, IntegratorKind integrator, bool quick) {
    Settings settings = rest_settings(scene, integrator, response, quick);
    double& step = settings.solver.dt;
    if (!has_step_limit(integrator)) step = long_step;
    const double shortest = step / 64;
    while (step >= shortest && step > 0.9 * Simulation(scene, settings).longest_step()) step /= 2;
    if (step < shortest) return {Row{{"end", "no_stable_step"}}};
    Row row{{"step_s", step}, {"end", "diverged"}};
    Simulation simulation(scene, settings);
    std::deque<double> squares;
    SleepWatch watch;
    const Real speed = load_scene(scene).solver.sleep_speed;
    const double& time = simulation.report().time;
    Row found{{"end", "awake"}};
    for (double end = 15; time < end;) {
        if (!run_until(simulation, time + step, squares)) return {row};
        const bool is_awake = found.word("end") == "awake";
        if (!is_awake || !watch.look(simulation.cloths(), simulation.balls(), time, speed)) continue;
        found = {{"end", "asleep"}, {"asleep_s", time}, {"speed_before_m_per_s", root_mean(squares)}};
        end = time + 2;
    }
    row.set(found);
    row.set("speed_after_m_per_s", root_mean(squares));
    return {row};
}

/// Lets the scene `drop` come to rest at a step, and then looks once a simulated second how far its cloth has crept:
/// `drift_m`, the farthest that any particle was from where it had come to rest.
/// @param seconds for which it is watched
Rows run_drift_case(IntegratorKind integrator, double step, double seconds, bool quick) {
    constexpr double settle = 8;  // s: everything rests that is going to
    const ResponseKind response = ResponseKind::Projection;
    Settings settings = rest_settings("drop", integrator, response, quick);
    settings.solver.dt = step;
    Row row{{"scene", "drop"}, {"response", response}, {"integrator", integrator}};
    row.set({{"step_s", step}, {"watched_s", seconds}, {"end", "diverged"}});
    Simulation simulation("drop", settings);
    std::deque<double> squares;
    if (!run_until(simulation, settle, squares)) return {row};
    const Points& x = simulation.cloths()[0].state.x;
    const Points rest = x;
    double drift = 0;
    for (double watched = 0; watched < seconds;) {
        watched = std::min(watched + 1, seconds);
        if (!run_until(simulation, settle + watched, squares)) return {row};
        drift = std::max(drift, static_cast<double>((x - rest).rowwise().norm().maxCoeff()));
    }
    row.set({{"end", "awake"}, {"drift_m", drift}, {"speed_after_m_per_s", root_mean(squares)}});
    return {row};
}

/// Every method by the longest of its steps, then by shorter ones, down to a tenth of a millisecond; then for ten
/// minutes by each of these, which takes hours, and a day for the shortest.
ExperimentCases drift_cases(bool quick) {
    constexpr double shipped = 3.125e-4, ten_minutes = 600;
    using Watches = std::vector<std::pair<double, double>>;  // step, and for how long [s]
    const Watches brief{{long_step, 2}, {1e-3, 4.0 / 3}};
    const Watches whole{{long_step, 6},           {1e-3, 4},           {1e-4, 2},
                        {long_step, ten_minutes}, {1e-3, ten_minutes}, {1e-4, ten_minutes}};
    ExperimentCases all;
    for (const auto& watch : quick ? brief : whole) {
        for (const IntegratorKind integrator : values_of<IntegratorKind>()) {
            if (integrator == IntegratorKind::ExplicitEuler) continue;  // no step of it is stable there
            const double longest = has_step_limit(integrator) ? shipped : long_step;
            if (watch.first < long_step && watch.first > longest) continue;
            all.push_back([=, step = std::min(watch.first, longest), seconds = watch.second] {
                return run_drift_case(integrator, step, seconds, quick);
            });
        }
    }
    return all;
}

}  // namespace

Experiment rest_experiment() {
    return {"rest",
            "do cloth and ball come to rest under every integrator and response, and stay there?",
            3,
            {"part", "scene", "response", "integrator", "step_s", "end", "asleep_s", "speed_before_m_per_s",
             "speed_after_m_per_s", "watched_s", "drift_m"},
            {{"rest",
              cases_over(run_rest_case,
                         Axis<ResponseKind>{"response", {ResponseKind::Projection}, values_of<ResponseKind>()},
                         Axis<const char*>{"scene", {"drop", "trampoline"}},
                         Axis<IntegratorKind>{"integrator", values_of<IntegratorKind>()}, quick_or_whole(true, false)),
              {}},
             {"drift", drift_cases, {}}}};
}

}  // namespace drape
