#include <array>
#include <cmath>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "lab/experiments.h"
#include "self_contact_trial.h"

namespace drape {

template <>
inline constexpr auto enum_names<FailSafe> = all_names<FailSafe>("none", "zones", "rejection");

namespace {

constexpr Real sheet_speed = 8;  // m/s

/// Those compared, in the order of the table.
constexpr std::array fail_safes{FailSafe::Zones, FailSafe::Rejection, FailSafe::None};

/// A run: one thickness, one step, one fail-safe.
struct SelfContactRow : SelfContactHistory {
    double thickness = 0, step = 0;
    FailSafe fail_safe{};
    double momentum_error = 0;
    Quartiles cpu = {};  ///< time for a simulated second [s]
};

/// CPU time for a simulated second, without an observer.
double time_sheets(const ContactScene& scene, double step, FailSafe fail_safe) {
    SelfContactTrial trial(scene, static_cast<Real>(step), fail_safe);
    return cpu_time_of([&] {
               for (auto left = std::llround(scene.end / step); left > 0; --left) trial.step();
           }) /
           scene.end;
}

/// The runs of a step, timed in turn.
std::vector<SelfContactRow> run_step(const ContactScene& scene, double step, const SelfContactHistory& reference,
                                     int repeats) {
    std::array<std::vector<double>, fail_safes.size()> cpu;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t k = 0; k < fail_safes.size(); ++k) cpu[k].push_back(time_sheets(scene, step, fail_safes[k]));
    }
    std::vector<SelfContactRow> rows;
    for (std::size_t k = 0; k < fail_safes.size(); ++k) {
        const SelfContactHistory run = watch_sheets(scene, static_cast<Real>(step), fail_safes[k]);
        rows.push_back({run, static_cast<double>(scene.settings.contact.thickness), step, fail_safes[k],
                        momentum_error(run, reference), quartiles_of(std::move(cpu[k]))});
    }
    return rows;
}

/// @throws RunError if the reference itself fails
std::vector<SelfContactRow> run_thickness(double thickness, const std::vector<double>& rates, int finer, int repeats) {
    const ContactScene scene = throw_sheet(sheet_speed, static_cast<Real>(thickness));
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
    return cases_over([=](double thickness) { return run_thickness(thickness, rates, quick ? 2 : 4, quick ? 1 : 5); },
                      std::vector{1.25e-4, 5e-4, 2e-3, 8e-3});
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
    using Row = SelfContactRow;
    return ExperimentOf<Row>{"self_contact",
                             "what keeps cloth from crossing cloth, and at which step?",
                             {6,
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
                               {number_column("cpu_s_per_s"), &Row::cpu}}},
                             {{"thickness_m", "step_s", "fail_safe"},
                              {"crossed_steps", "unsearched_steps", "penetration_m", "momentum_error", "cpu_s_per_s"}},
                             {{"", self_contact_cases, self_contact_charts}}};
}

}  // namespace drape
