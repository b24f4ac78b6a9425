#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/integrate/stability.h"
#include "drape/integrate/stability_trial.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"

namespace drape {
namespace {

/// What a case is about: a sheet, and the method that moves it.
struct Subject {
    Method method;
    const char* sweep;        ///< what varies: stiffness, damping, or damped_stiffness
    int side;                 ///< particles along each
    Real stiffness, damping;  ///< of every spring [N/m, N s/m]
    int steps;
};

constexpr Real longest_tried = Real(0.05);                     // s
constexpr Real swept_stiffness[] = {1e2, 1e3, 1e4, 1e5, 1e6};  // N/m
constexpr Real stiffness_when_damped = 1e4;                    // N/m
constexpr Real damping_when_damped = Real(0.1);                // N s/m

std::vector<Method> stability_methods() {
    return methods_named({"explicit_euler", "symplectic_euler", "velocity_verlet", "rk4", "backward_euler_clamped",
                          "backward_euler_exact", "implicit_midpoint_clamped", "implicit_midpoint_exact",
                          "bdf2_clamped", "bdf2_exact", "xpbd_1", "xpbd_20", "projective_dynamics"});
}

struct Sheet {
    ClothModel model;
    ClothState state;
};

/// Where the limit is linear: a free flat sheet without gravity, so that it is tried in the state that the prediction
/// is about. Elsewhere: a sheet that falls and swings, hung by two corners.
Sheet sheet_of(const Subject& subject) {
    const bool limited = has_step_limit(subject.method.parameters.kind);
    ClothParameters parameters;
    parameters.particles = {subject.side, subject.side};
    parameters.structural = parameters.shear = parameters.bend = {subject.stiffness, subject.damping};
    parameters.drag = 0;
    if (!limited) parameters.pinned.kind = Pins::Kind::Two;
    Sheet sheet{make_cloth_model(parameters), make_rest_state(parameters)};
    if (limited) sheet.model.gravity.setZero();
    return sheet;
}

/// What is known before the trials.
struct Forecast {
    StepLimit limit;
    Real expected;   ///< where trials should start to fail [s]
    Real tolerance;  ///< of `expected`
};

Forecast forecast(const Subject& subject, const Sheet& sheet) {
    const IntegratorKind kind = subject.method.parameters.kind;
    const Kernels kernels = subject.method.parameters.kernels;
    const StepLimit limit = predicted_limit(sheet.model, sheet.state, kind, kernels);
    if (kind != IntegratorKind::ExplicitEuler) return {limit, limit.step, Real(0.03)};
    const StepLimit fastest = predicted_limit(sheet.model, sheet.state, IntegratorKind::SymplecticEuler, kernels);
    const Real expected = observable_limit_of_explicit_euler(sheet.model, sheet.state, fastest.omega, fastest.zeta,
                                                             kernels, subject.steps);
    return {limit, expected, Real(0.15)};
}

std::string agreement(Real step, TrialEnd end, const Forecast& forecast) {
    const bool bounded = end == TrialEnd::Bounded;
    if (step < (1 - forecast.tolerance) * forecast.expected) return bounded ? "agrees" : "disagrees";
    if (step > (1 + forecast.tolerance) * forecast.expected) return bounded ? "disagrees" : "agrees";
    return "close";
}

Rows run_stability_case(const Subject& subject) {
    const Sheet sheet = sheet_of(subject);
    const Forecast known = forecast(subject, sheet);
    const IntegratorParameters& method = subject.method.parameters;
    std::vector<std::pair<Real, TrialEnd>> tried;
    const auto note = [&tried](Real step, TrialEnd end) { tried.emplace_back(step, end); };

    Real measured = std::numeric_limits<Real>::infinity();
    if (std::isfinite(known.expected)) {
        // The search knows the prediction only as a rough start
        measured = measured_limit(sheet.model, sheet.state, method, Real(0.6) * known.expected, 1, subject.steps, note);
        for (const double part : {0.1, 0.25, 0.5, 0.75, 0.9, 1.1, 1.25, 2.0, 4.0, 10.0}) {
            const Real step = static_cast<Real>(part) * known.expected;
            note(step, try_step(sheet.model, sheet.state, method, step, subject.steps));
        }
    } else {
        for (const Real step : {Real(1e-3), Real(1) / 240, Real(1) / 60, Real(1) / 30, longest_tried}) {
            note(step, try_step(sheet.model, sheet.state, method, step, subject.steps));
            if (tried.back().second != TrialEnd::Bounded) measured = std::min(measured, step);
        }
    }

    Rows rows;
    for (const auto& [step, end] : tried) {
        rows.push_back({{"method", subject.method.name},
                        {"sweep", subject.sweep},
                        {"side", subject.side},
                        {"stiffness_N_per_m", subject.stiffness},
                        {"damping_N_s_per_m", subject.damping},
                        {"omega_per_s", known.limit.omega},
                        {"zeta", known.limit.zeta},
                        {"predicted_step_s", known.limit.step},
                        {"expected_step_s", known.expected},
                        {"measured_step_s", measured},
                        {"step_s", step},
                        {"end", end},
                        {"agreement", agreement(step, end, known)}});
    }
    return rows;
}

ExperimentCases stability_cases(bool quick) {
    const std::vector<double> swept_damping = quick ? std::vector<double>{0.01, 0.1, 1, 10}  // N s/m
                                                    : std::vector<double>{0.01, 0.03, 0.1, 0.3, 1, 3, 10};
    ExperimentCases all;
    const auto add = [&all](const Method& method, const char* sweep, int side, Real stiffness, Real damping,
                            int steps) {
        const Subject subject{method, sweep, side, stiffness, damping, steps};
        all.push_back([=] { return run_stability_case(subject); });
    };
    for (const Method& method : stability_methods()) {
        const bool limited = has_step_limit(method.parameters.kind);
        const int charted = limited ? (quick ? 16 : 30) : (quick ? 8 : 16);
        const int steps = limited ? 3000 : (quick ? 300 : 1000);
        const std::vector<int> sides = limited && !quick ? std::vector{16, 64, charted} : std::vector{charted};
        for (const int side : sides) {
            for (const Real k : swept_stiffness) add(method, "stiffness", side, k, 0, steps);
        }
        for (const Real k : swept_stiffness) {
            if (!limited) add(method, "damped_stiffness", charted, k, damping_when_damped, steps);
        }
        for (const double c : swept_damping) {
            add(method, "damping", charted, stiffness_when_damped, static_cast<Real>(c), steps);
        }
    }
    return all;
}

/// @param rows of one method, at least one
Chart stability_chart(Rows rows) {
    // The sheet that is drawn is the last of its method
    const double side = rows.back().number("side");
    std::erase_if(rows, [side](const Row& row) { return row.number("side") != side; });
    const auto count = [&rows](const char* column, const char* word) {
        return static_cast<double>(rows_with(rows, column, word).size());
    };
    const std::string method = rows.front().word("method");
    const bool limited = std::isfinite(rows.front().number("expected_step_s"));
    return {"stability_" + method,
            {{"method", method},
             {"side", side},
             {"trials", static_cast<double>(rows.size()) - count("agreement", "close")},
             {"against", count("agreement", "disagrees")},
             {"limited", limited ? 1. : 0.},
             {"stiffness", count("sweep", "stiffness") > 0 ? 1. : 0.},
             {"damping", count("sweep", "damping") > 0 ? 1. : 0.}},
            {},
            "stability"};
}

/// A chart a method.
std::vector<Chart> stability_charts(Rows rows) {
    // The damped sweep of stiffness is for the table only
    std::erase_if(rows, [](const Row& row) { return row.word("sweep") == "damped_stiffness"; });
    std::vector<Chart> charts;
    for (const std::string& method : words_of(rows, "method")) {
        charts.push_back(stability_chart(rows_with(rows, "method", method)));
    }
    return charts;
}

}  // namespace

Experiment stability_experiment() {
    return {"stability",
            "which steps stay bounded, and is that what is predicted?",
            6,
            {word_column("method", names_in(stability_methods(), &Method::name)),
             word_column("sweep", {"stiffness", "damping", "damped_stiffness"}),  // what varies
             whole_column("side", 2),                                             // particles along each
             number_column("stiffness_N_per_m"),
             number_column("damping_N_s_per_m"),  // of every spring
             number_column("omega_per_s"),
             number_column("zeta"),                                 // of the mode that sets the limit
             number_column("predicted_step_s").or_words({"inf"}),   // the linear limit
             positive_column("expected_step_s").or_words({"inf"}),  // where trials should start to fail
             number_column("measured_step_s").or_words({"inf"}),    // where they did
             positive_column("step_s"), name_column<TrialEnd>("end"),
             word_column("agreement", {"agrees", "disagrees", "close"})},
            {{"method", "sweep", "agreement"}, {"expected_step_s", "measured_step_s"}},
            {{"", stability_cases, stability_charts}}};
}

}  // namespace drape
