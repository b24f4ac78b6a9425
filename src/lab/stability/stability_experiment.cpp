#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/integrate/stability.h"
#include "drape/integrate/stability_trial.h"
#include "lab/experiments.h"
#include "stability_row.h"

namespace drape {
namespace {

/// A method under the name that table and chart give it.
struct Method {
    std::string name;
    IntegratorParameters parameters;
};

/// What a case is about: a sheet, and the method that moves it.
struct Subject {
    Method method;
    std::string sweep;  ///< what varies: stiffness, damping, or damped_stiffness
    int side;           ///< particles
    Real stiffness, damping;
    int steps;
};

constexpr Real longest_tried = Real(0.05);                       // s
constexpr double swept_stiffness[] = {1e2, 1e3, 1e4, 1e5, 1e6};  // N/m
constexpr Real stiffness_when_damped = 1e4;                      // N/m
constexpr Real damping_when_damped = Real(0.1);                  // N s/m

std::vector<Method> methods() {
    using enum IntegratorKind;
    std::vector<Method> all;
    const auto add = [&all](std::string name, const IntegratorParameters& parameters) {
        all.push_back({std::move(name), parameters});
    };
    for (const auto kind : {ExplicitEuler, SymplecticEuler, VelocityVerlet, Rk4}) {
        add(std::string(name_of(kind)), {.kind = kind});
    }
    for (const auto kind : {BackwardEuler, ImplicitMidpoint, Bdf2}) {
        add(std::string(name_of(kind)) + "_clamped", {.kind = kind, .hessian = Hessian::Clamped});
        add(std::string(name_of(kind)) + "_exact", {.kind = kind, .hessian = Hessian::Exact});
    }
    add("xpbd_1", {.kind = Xpbd, .iterations = 1});
    add("xpbd_20", {.kind = Xpbd, .iterations = 20});
    add("projective_dynamics", {.kind = ProjectiveDynamics});
    return all;
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
                                                             kernels, {.steps = subject.steps});
    return {limit, expected, Real(0.15)};
}

std::string agreement(Real step, TrialEnd end, const Forecast& forecast) {
    const bool bounded = end == TrialEnd::Bounded;
    if (step < (1 - forecast.tolerance) * forecast.expected) return bounded ? "agrees" : "disagrees";
    if (step > (1 + forecast.tolerance) * forecast.expected) return bounded ? "disagrees" : "agrees";
    return "close";
}

std::vector<StabilityRow> run_stability_case(const Subject& subject) {
    const Sheet sheet = sheet_of(subject);
    const Forecast known = forecast(subject, sheet);
    const IntegratorParameters& method = subject.method.parameters;
    const Trial trial{.steps = subject.steps};
    std::vector<std::pair<Real, TrialEnd>> tried;
    const auto note = [&tried](Real step, TrialEnd end) { tried.emplace_back(step, end); };

    Real measured = std::numeric_limits<Real>::infinity();
    if (std::isfinite(known.expected)) {
        // The search knows the prediction only as a rough start
        measured = measured_limit(sheet.model, sheet.state, method, Real(0.6) * known.expected, 1, trial, note);
        for (const double part : {0.1, 0.25, 0.5, 0.75, 0.9, 1.1, 1.25, 2.0, 4.0, 10.0}) {
            const Real step = static_cast<Real>(part) * known.expected;
            note(step, try_step(sheet.model, sheet.state, method, step, trial));
        }
    } else {
        for (const Real step : {Real(1e-3), Real(1) / 240, Real(1) / 60, Real(1) / 30, longest_tried}) {
            note(step, try_step(sheet.model, sheet.state, method, step, trial));
            if (tried.back().second != TrialEnd::Bounded) measured = std::min(measured, step);
        }
    }

    StabilityRow row{.method = subject.method.name,
                     .sweep = subject.sweep,
                     .side = static_cast<double>(subject.side),
                     .stiffness = static_cast<double>(subject.stiffness),
                     .damping = static_cast<double>(subject.damping),
                     .omega = static_cast<double>(known.limit.omega),
                     .zeta = static_cast<double>(known.limit.zeta),
                     .predicted = static_cast<double>(known.limit.step),
                     .expected = static_cast<double>(known.expected),
                     .measured = static_cast<double>(measured)};
    std::vector<StabilityRow> rows;
    for (const auto& [step, end] : tried) {
        row.step = static_cast<double>(step), row.end = name_of(end), row.agreement = agreement(step, end, known);
        rows.push_back(row);
    }
    return rows;
}

std::vector<CaseOf<StabilityRow>> stability_cases(bool quick) {
    const std::vector<double> swept_damping = quick ? std::vector<double>{0.01, 0.1, 1, 10}  // N s/m
                                                    : std::vector<double>{0.01, 0.03, 0.1, 0.3, 1, 3, 10};
    std::vector<CaseOf<StabilityRow>> all;
    const auto add = [&all](const Subject& subject) {
        all.push_back([subject] { return run_stability_case(subject); });
    };
    for (const Method& method : methods()) {
        const bool limited = has_step_limit(method.parameters.kind);
        const int charted = limited ? (quick ? 16 : 30) : (quick ? 8 : 16);
        const int steps = limited ? 3000 : (quick ? 300 : 1000);
        const std::vector<int> sides = limited && !quick ? std::vector{16, 64, charted} : std::vector{charted};
        for (const int side : sides) {
            for (const double k : swept_stiffness) add({method, "stiffness", side, static_cast<Real>(k), 0, steps});
        }
        for (const double k : swept_stiffness) {
            if (!limited) add({method, "damped_stiffness", charted, static_cast<Real>(k), damping_when_damped, steps});
        }
        for (const double c : swept_damping) {
            add({method, "damping", charted, stiffness_when_damped, static_cast<Real>(c), steps});
        }
    }
    return all;
}

RowFormat<StabilityRow> stability_format() {
    using Row = StabilityRow;
    std::vector<std::string> names, unlimited, ends;
    for (const Method& method : methods()) {
        names.push_back(method.name);
        if (!has_step_limit(method.parameters.kind)) unlimited.push_back(method.name);
    }
    for (int end = 0; end <= static_cast<int>(TrialEnd::Stretched); ++end) {
        ends.emplace_back(name_of(static_cast<TrialEnd>(end)));
    }
    const auto or_none = [&unlimited](const Column& step) { return step.or_words({"inf"}).where("method", unlimited); };
    return {6,
            {{word_column("method", names), &Row::method},
             {word_column("sweep", {"stiffness", "damping", "damped_stiffness"}), &Row::sweep},
             {whole_column("side", 2), &Row::side},
             {number_column("stiffness_N_per_m"), &Row::stiffness},
             {number_column("damping_N_s_per_m"), &Row::damping},
             {number_column("omega_per_s"), &Row::omega},
             {number_column("zeta"), &Row::zeta},
             {or_none(number_column("predicted_step_s")), &Row::predicted},
             {or_none(positive_column("expected_step_s")), &Row::expected},
             {or_none(number_column("measured_step_s")), &Row::measured},
             {positive_column("step_s"), &Row::step},
             {word_column("end", ends), &Row::end},
             {word_column("verdict", {"agrees", "disagrees", "close"}), &Row::agreement}}};
}

}  // namespace

Experiment stability_experiment() {
    return ExperimentOf<StabilityRow>{"stability",        "which steps stay bounded, and is that what is predicted?",
                                      stability_format(), stability_cases,
                                      stability_charts,   stability_summary}
        .as_table();
}

}  // namespace drape
