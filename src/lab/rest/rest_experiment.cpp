#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "lab/experiments.h"
#include "rest_run.h"

namespace drape {
namespace {

/// A scene by one integrator with one response.
struct RestRow {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::string scene, integrator, response, end;
    double step = none;  ///< [s]
    double asleep = none, speed_before = none, speed_after = none;
};

/// Below this a scene is at rest [m/s].
constexpr double resting_speed = 1e-4;

constexpr double longest_run = 15;
constexpr int quick_particles = 9;

std::vector<RestRow> run_rest_case(const RestCase& one, bool quick) {
    RestRow row{one.scene, name_of(one.integrator), name_of(one.response), "no_stable_step"};
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
            {{word_column("scene", {"drop", "trampoline"}), &Row::scene},
             {name_column<ResponseKind>("response"), &Row::response},
             {name_column<IntegratorKind>("integrator"), &Row::integrator},
             {positive_column("step_s").or_nan().where("end", {"no_stable_step"}), &Row::step},
             {word_column("end", {"asleep", "awake", "diverged", "no_stable_step"}), &Row::end},
             {of_sleep(positive_column("asleep_s")), &Row::asleep},
             {of_sleep(number_column("speed_before_m_per_s")), &Row::speed_before},
             {of_runs(number_column("speed_after_m_per_s")), &Row::speed_after}}};
}

std::string rest_summary(const std::vector<RestRow>& rows) {
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

}  // namespace

Experiment rest_experiment() {
    return ExperimentOf<RestRow>{"rest",
                                 "do cloth and ball come to rest under every integrator and response?",
                                 rest_format(),
                                 rest_cases,
                                 [](const auto&) { return std::vector<Chart>{}; },
                                 rest_summary}
        .as_table();
}

}  // namespace drape
