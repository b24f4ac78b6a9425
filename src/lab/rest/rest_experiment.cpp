#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "drape/integrate/stability.h"
#include "lab/experiments.h"
#include "rest_run.h"

namespace drape {
namespace {

/// A scene by one integrator with one response: how it comes to rest, or how it then creeps.
struct RestRow {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::string part;  ///< rest or drift
    std::string scene, integrator, response, end;
    double step = none;  ///< [s]
    double asleep = none, speed_before = none, speed_after = none;
    double watched = none, drift = none;  ///< of `DriftRun` [s], [m]
};

/// Below this a scene is at rest [m/s].
constexpr double resting_speed = 3e-4;

constexpr double longest_run = 15;
constexpr int quick_particles = 9;

std::vector<RestRow> run_rest_case(const RestCase& one, bool quick) {
    RestRow row{"rest", one.scene, name_of(one.integrator), name_of(one.response), "no_stable_step"};
    const Settings settings = rest_settings(one, quick ? quick_particles : 0);
    if (settings.solver.dt == 0) return {row};
    const RestRun run = run_to_rest(one.scene, settings, longest_run);
    row.step = run.step;
    row.end = run.diverged ? "diverged" : "awake";
    if (run.diverged) return {row};
    row.speed_after = run.speed_after;
    if (run.asleep < 0) return {row};
    row.end = "asleep";
    row.asleep = run.asleep;
    row.speed_before = run.speed_before;
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

std::vector<RestRow> run_drift_case(const DriftCase& one, bool quick) {
    const RestCase rest{"drop", one.integrator, ResponseKind::Projection};
    Settings settings = rest_settings(rest, quick ? quick_particles : 0);
    settings.solver.dt = one.step;
    const DriftRun run = watch_drift(rest.scene, settings, settle, one.seconds);
    RestRow row{"drift", rest.scene, name_of(rest.integrator), name_of(rest.response),
                run.diverged ? "diverged" : "awake"};
    row.step = one.step;
    row.watched = one.seconds;
    if (run.diverged) return {row};
    row.drift = run.drift;
    row.speed_after = run.speed;
    return {row};
}

/// Every method by the longest of its steps, then by shorter ones, down to a tenth of a millisecond; then for ten
/// minutes by each of these, which takes hours, and a day for the shortest.
std::vector<DriftCase> drift_list(bool quick) {
    constexpr double shipped = 3.125e-4, ten_minutes = 600;
    struct Watch {
        double step, seconds;
    };
    std::vector<DriftCase> all;
    for (const Watch& watch : {Watch{long_step, 6},
                               {1e-3, 4},
                               {1e-4, 2},
                               {long_step, ten_minutes},
                               {1e-3, ten_minutes},
                               {1e-4, ten_minutes}}) {
        for (const std::string& name : names_of<IntegratorKind>()) {
            const IntegratorKind integrator = value_named<IntegratorKind>(name).value();
            if (integrator == IntegratorKind::ExplicitEuler) continue;  // no step of it is stable there
            const double longest = has_step_limit(integrator) ? shipped : long_step;
            if (watch.step == long_step || watch.step <= longest) {
                all.push_back({integrator, std::min(watch.step, longest), watch.seconds});
            }
        }
    }
    if (quick) {
        std::erase_if(all, [](const DriftCase& one) { return one.step < shipped || one.seconds == ten_minutes; });
        for (DriftCase& one : all) one.seconds /= 3;
    }
    return all;
}

std::vector<CaseOf<RestRow>> rest_cases(bool quick) {
    std::vector<CaseOf<RestRow>> all;
    for (const std::string& response : names_of<ResponseKind>()) {
        const ResponseKind kind = value_named<ResponseKind>(response).value();
        if (quick && kind != ResponseKind::Projection) continue;
        for (const char* scene : {"drop", "trampoline"}) {
            for (const std::string& integrator : names_of<IntegratorKind>()) {
                const RestCase one{scene, value_named<IntegratorKind>(integrator).value(), kind};
                all.push_back([=] { return run_rest_case(one, quick); });
            }
        }
    }
    for (const DriftCase& one : drift_list(quick)) all.push_back([=] { return run_drift_case(one, quick); });
    return all;
}

RowFormat<RestRow> rest_format() {
    using Row = RestRow;
    const auto of_runs = [](const Column& column) {
        return column.or_nan().where("end", {"diverged", "no_stable_step"});
    };
    const auto of_sleep = [](const Column& column) {
        return column.or_nan().where("end", {"awake", "diverged", "no_stable_step"});
    };
    return {3,
            {{word_column("part", {"rest", "drift"}), &Row::part},
             {word_column("scene", {"drop", "trampoline"}), &Row::scene},
             {name_column<ResponseKind>("response"), &Row::response},
             {name_column<IntegratorKind>("integrator"), &Row::integrator},
             {positive_column("step_s").or_nan().where("end", {"no_stable_step"}), &Row::step},
             {word_column("end", {"asleep", "awake", "diverged", "no_stable_step"}), &Row::end},
             {of_sleep(positive_column("asleep_s")), &Row::asleep},
             {of_sleep(number_column("speed_before_m_per_s")), &Row::speed_before},
             {of_runs(number_column("speed_after_m_per_s")), &Row::speed_after},
             {positive_column("watched_s").or_nan().where("part", {"rest"}), &Row::watched},
             {number_column("drift_m").or_nan(), &Row::drift}}};
}

std::string summary_of_rest(const std::vector<RestRow>& rows) {
    if (rows.empty()) return {};
    const auto rests = [](const RestRow& row) { return row.end == "asleep" && row.speed_before < resting_speed; };
    std::string text = fmt::format("{} of {} are below {} mm/s RMS when they fall asleep\n",
                                   std::ranges::count_if(rows, rests), rows.size(), 1e3 * resting_speed);
    for (const RestRow& row : rows) {
        if (rests(row)) continue;
        text += fmt::format("{}, {}, {}: {}", row.scene, row.response, row.integrator, row.end);
        if (row.end == "asleep") text += fmt::format(" at {:.3g} s, {:.3g} mm/s", row.asleep, 1e3 * row.speed_before);
        if (row.end == "awake") text += fmt::format(", {:.3g} mm/s", 1e3 * row.speed_after);
        text += '\n';
    }
    return text;
}

std::string rest_summary(const std::vector<RestRow>& rows) {
    std::string text = summary_of_rest(rows_with(rows, &RestRow::part, "rest"));
    for (const RestRow& row : rows_with(rows, &RestRow::part, "drift")) {
        text += fmt::format("{}, step {:.3g} ms: ", row.integrator, 1e3 * row.step);
        text += row.end == "diverged"
                    ? "diverged\n"
                    : fmt::format("has crept by {:.3g} mm after {:.3g} s\n", 1e3 * row.drift, row.watched);
    }
    return text;
}

}  // namespace

Experiment rest_experiment() {
    return ExperimentOf<RestRow>{"rest",
                                 "do cloth and ball come to rest under every integrator and response, and stay there?",
                                 rest_format(),
                                 rest_cases,
                                 [](const auto&) { return std::vector<Chart>{}; },
                                 rest_summary}
        .as_table();
}

}  // namespace drape
