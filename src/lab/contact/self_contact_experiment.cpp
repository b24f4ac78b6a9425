#include <fmt/core.h>

#include <array>
#include <cmath>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "lab/experiments.h"
#include "self_contact_trial.h"

namespace drape {
namespace {

constexpr Real sheet_speed = 8;  // m/s

/// Those compared, as the table names them.
constexpr std::array<std::pair<FailSafe, const char*>, 3> fail_safes{
    {{FailSafe::Zones, "zones"}, {FailSafe::Rejection, "rejection"}, {FailSafe::None, "none"}}};

/// A run: one thickness, one step, one fail-safe.
struct SelfContactRow {
    double thickness = 0, step = 0;
    std::string fail_safe;
    double crossings = 0, crossed_steps = 0, unsearched_steps = 0, unsafe_steps = 0;
    double penetration = 0, momentum_error = 0, momentum_change = 0;
    double pair_tests = 0, held_back = 0, rejected = 0;
    Quartiles cpu = {};  ///< time for a simulated second [s]
};

/// CPU time for a simulated second, without an observer.
double time_sheets(const ThrownSheet& scene, double step, FailSafe fail_safe) {
    SelfContactTrial trial(scene, static_cast<Real>(step), fail_safe);
    const double before = thread_cpu_time();
    for (auto left = std::llround(scene.end / step); left > 0; --left) trial.advance();
    return (thread_cpu_time() - before) / scene.end;
}

/// The runs of a step, timed in turn.
std::vector<SelfContactRow> run_step(const ThrownSheet& scene, double step, const SelfContactHistory& reference,
                                     int repeats) {
    std::array<std::vector<double>, fail_safes.size()> cpu;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t k = 0; k < fail_safes.size(); ++k) {
            cpu[k].push_back(time_sheets(scene, step, fail_safes[k].first));
        }
    }
    std::vector<SelfContactRow> rows;
    for (std::size_t k = 0; k < fail_safes.size(); ++k) {
        const SelfContactHistory run = watch_sheets(scene, static_cast<Real>(step), fail_safes[k].first);
        rows.push_back({.thickness = static_cast<double>(scene.settings.contact.thickness),
                        .step = step,
                        .fail_safe = fail_safes[k].second,
                        .crossings = static_cast<double>(run.crossings),
                        .crossed_steps = run.crossed_steps,
                        .unsearched_steps = run.unsearched_steps,
                        .unsafe_steps = run.unsafe_steps,
                        .penetration = run.penetration,
                        .momentum_error = momentum_error(run, reference),
                        .momentum_change = run.momentum_change,
                        .pair_tests = run.pair_tests,
                        .held_back = run.held_back,
                        .rejected = run.rejected,
                        .cpu = quartiles_of(std::move(cpu[k]))});
    }
    return rows;
}

/// @throws RunError if the reference itself fails
std::vector<SelfContactRow> run_thickness(double thickness, const std::vector<double>& rates, int finer, int repeats) {
    const ThrownSheet scene = throw_sheet(sheet_speed, static_cast<Real>(thickness));
    const SelfContactHistory reference =
        watch_sheets(scene, static_cast<Real>(1 / (finer * rates.back())), FailSafe::Zones);
    if (reference.crossed_steps > 0 || reference.unsearched_steps > 0) {
        throw RunError("self_contact: sheets of the reference have crossed");
    }
    std::vector<SelfContactRow> rows;
    for (const double rate : rates) {
        for (SelfContactRow& row : run_step(scene, 1 / rate, reference, repeats)) rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<CaseOf<SelfContactRow>> self_contact_cases(bool quick) {
    const auto rates =
        quick ? std::vector{120.0, 240.0, 480.0, 960.0} : std::vector{60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0};
    std::vector<CaseOf<SelfContactRow>> all;
    for (const double thickness : {1.25e-4, 5e-4, 2e-3, 8e-3}) {
        all.push_back([=] { return run_thickness(thickness, rates, quick ? 2 : 4, quick ? 1 : 5); });
    }
    return all;
}

RowFormat<SelfContactRow> self_contact_format() {
    using Row = SelfContactRow;
    return {6,
            {{positive_column("thickness_m"), &Row::thickness},
             {positive_column("step_s"), &Row::step},
             {word_column("fail_safe", {"zones", "rejection", "none"}), &Row::fail_safe},
             {whole_column("crossings"), &Row::crossings},
             {number_column("crossed_steps"), &Row::crossed_steps},
             {number_column("unsearched_steps"), &Row::unsearched_steps},
             {number_column("unsafe_steps"), &Row::unsafe_steps},
             {number_column("penetration_m"), &Row::penetration},
             {number_column("momentum_error"), &Row::momentum_error},
             {number_column("momentum_change"), &Row::momentum_change},
             {number_column("pair_tests"), &Row::pair_tests},
             {number_column("held_back"), &Row::held_back},
             {number_column("rejected"), &Row::rejected},
             {number_column("cpu_s_per_s"), &Row::cpu}}};
}

std::string self_contact_summary(const std::vector<SelfContactRow>& rows) {
    std::string text;
    for (const SelfContactRow& row : rows) {
        text += fmt::format(
            "{:.3g} mm, step 1/{:.0f} s, fail-safe {}: crossings after {:.0f} % of the steps, no search in {:.0f} %, "
            "penetration {:.3g} mm, momentum off by {:.3g} %\n",
            1e3 * row.thickness, 1 / row.step, row.fail_safe, 1e2 * row.crossed_steps, 1e2 * row.unsearched_steps,
            1e3 * row.penetration, 1e2 * row.momentum_error);
    }
    return text;
}

std::vector<Chart> self_contact_charts(const std::vector<SelfContactRow>& rows) {
    const auto shown = words_of(rows, [](const SelfContactRow& row) { return real_text(1e3 * row.thickness, 4); });
    return {{"self_contact",
             "self_contact",
             "A sheet that is thrown at another, with impact zones or rejected steps as the fail-safe, and with none: "
             "the steps that end with cloth across cloth, how near two features come within the thickness, the error "
             "of the momentum that is passed on, and the tests of pairs, against the step. Rings mark runs in which "
             "the search gave up.",
             {{"thicknesses", in_words(shown)}}}};
}

}  // namespace

Experiment self_contact_experiment() {
    return ExperimentOf<SelfContactRow>{
        "self_contact",        "what keeps cloth from crossing cloth, and at which step?",
        self_contact_format(), self_contact_cases,
        self_contact_charts,   self_contact_summary}
        .as_table();
}

}  // namespace drape
