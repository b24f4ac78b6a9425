#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "drape/integrate/stability.h"
#include "lab/experiments.h"
#include "precision_diagram.h"
#include "precision_run.h"
#include "reference.h"

namespace drape {
namespace {

constexpr int timings_of_a_run = 7;

/// A method with its variant, under the name that the table gives it.
struct PrecisionMethod {
    std::string name;
    IntegratorParameters parameters;
    int too_long = 2;  ///< with a step limit: steps beyond it that are tried
};

/// All of them, in the order of the table.
std::vector<PrecisionMethod> precision_methods() {
    using enum IntegratorKind;
    using enum Hessian;
    // Not far below its limit RK4 is as exact as the reference: its ladder starts farther above
    return {{"explicit_euler", {.kind = ExplicitEuler}},
            {"symplectic_euler", {.kind = SymplecticEuler}},
            {"velocity_verlet", {.kind = VelocityVerlet}},
            {"rk4", {.kind = Rk4}, 4},
            {"dormand_prince", {.kind = DormandPrince}},
            {"backward_euler", {.kind = BackwardEuler}},
            {"implicit_midpoint_clamped", {.kind = ImplicitMidpoint, .hessian = Clamped}},
            {"implicit_midpoint_exact", {.kind = ImplicitMidpoint, .hessian = Exact}},
            {"bdf2_clamped", {.kind = Bdf2, .hessian = Clamped}},
            {"bdf2_exact", {.kind = Bdf2, .hessian = Exact}},
            {"xpbd_1", {.kind = Xpbd, .iterations = 1}},
            {"xpbd_5", {.kind = Xpbd, .iterations = 5}},
            {"xpbd_20", {.kind = Xpbd, .iterations = 20}},
            {"projective_dynamics_5", {.kind = ProjectiveDynamics, .iterations = 5}},
            {"projective_dynamics_20", {.kind = ProjectiveDynamics, .iterations = 20}}};
}

/// A scene, and its reference once a case has asked for it: each process computes it at most once.
class Arena {
public:
    explicit Arena(PrecisionScene scene) : scene_(std::move(scene)) {}
    [[nodiscard]] const PrecisionScene& scene() const { return scene_; }
    const Reference& reference() {
        if (!reference_) reference_ = find_reference(scene_);
        return *reference_;
    }

private:
    PrecisionScene scene_;
    std::optional<Reference> reference_;
};

/// One point of a diagram.
struct Rung {
    IntegratorParameters parameters;
    int steps;
};

/// Counts of steps, doubled from one to the next; with no ball, Dormand-Prince has falling tolerances in their place.
std::vector<Rung> ladder(const PrecisionMethod& method, const PrecisionScene& scene) {
    constexpr int coarsest = 8;
    std::vector<Rung> rungs;
    const auto add = [&](int first, int last) {
        for (int steps = first; steps <= last; steps *= 2) rungs.push_back({method.parameters, steps});
    };
    if (scene.has_ball()) {
        add(coarsest, scene.finest_steps);
    } else if (method.parameters.kind == IntegratorKind::DormandPrince) {
        for (Real tolerance = Real(1e-2); tolerance > Real(0.9e-8); tolerance /= 10) {
            rungs.push_back({method.parameters, outer_steps});
            rungs.back().parameters.tolerance = tolerance;
        }
    } else if (has_step_limit(method.parameters.kind)) {
        // From the last steps beyond the limit at rest
        const ClothParameters& cloth = scene.settings.cloths.front();
        const Real limit = predicted_limit(make_cloth_model(cloth), make_rest_state(cloth), method.parameters.kind,
                                           method.parameters.kernels)
                               .step;
        int first = 1;
        while (scene.horizon / static_cast<Real>(first) > 2 * limit) first *= 2;
        first = std::max(first >> (method.too_long - 1), 1);
        add(first, first << (scene.rungs - 1));
    } else {
        add(coarsest, scene.finest_steps);
    }
    return rungs;
}

/// The error of a rung over the places of the first impact within a step.
struct Outcome {
    bool bounded = true;
    double error = 0;  ///< root mean square
    int inner_steps = 0;
};

Outcome outcome_of(const Rung& rung, const PrecisionScene& scene, const Reference& reference) {
    const ClothModel model = make_cloth_model(scene.settings.cloths.front());
    Outcome outcome;
    double squares = 0;
    for (int phase = 0; phase < scene.phases && outcome.bounded; ++phase) {
        const Real place =
            scene.has_ball() ? (static_cast<Real>(phase) + Real(0.5)) / static_cast<Real>(scene.phases) : 0;
        const Finish end = finish(scene, rung.parameters, steps_to(scene.horizon, rung.steps, place));
        const double error = error_of(reference.measure, model, end.state, reference.state, scene.side());
        outcome.bounded = end.bounded;
        outcome.inner_steps = end.inner_steps;
        squares += error * error;
    }
    outcome.error = std::sqrt(squares / scene.phases);
    return outcome;
}

PrecisionRow row_of(const PrecisionMethod& method, const Rung& rung, const PrecisionScene& scene,
                    const Reference& reference) {
    const Outcome outcome = outcome_of(rung, scene, reference);
    const bool adaptive = method.parameters.kind == IntegratorKind::DormandPrince;
    const int steps = adaptive && !scene.has_ball() ? outcome.inner_steps : rung.steps;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const Quartiles cost =
        outcome.bounded ? cost_of(scene, rung.parameters, rung.steps, timings_of_a_run) : Quartiles{none, none, none};
    return {.scene = scene.name,
            .particles = static_cast<double>(scene.settings.cloths.front().particles.nx),
            .stiffness = static_cast<double>(scene.settings.cloths.front().structural.stiffness),
            .horizon = static_cast<double>(scene.horizon),
            .phases = static_cast<double>(scene.phases),
            .method = method.name,
            .tolerance = adaptive ? static_cast<double>(rung.parameters.tolerance) : none,
            .steps = static_cast<double>(steps),
            .step = static_cast<double>(scene.horizon / static_cast<Real>(steps)),
            .end = outcome.bounded ? "bounded" : "unstable",
            .measure = std::string(name_of(reference.measure)),
            .error = outcome.bounded ? outcome.error : none,
            .cost_lower = cost.lower,
            .cost = cost.median,
            .cost_upper = cost.upper,
            .reference_error = reference.error,
            .growth = reference.growth};
}

std::vector<CaseOf<PrecisionRow>> precision_cases(bool quick) {
    std::vector<CaseOf<PrecisionRow>> all;
    for (PrecisionScene& scene : precision_scenes(quick)) {
        const auto arena = std::make_shared<Arena>(std::move(scene));
        for (const PrecisionMethod& method : precision_methods()) {
            all.push_back([arena, method] {
                std::vector<PrecisionRow> rows;
                for (const Rung& rung : ladder(method, arena->scene())) {
                    rows.push_back(row_of(method, rung, arena->scene(), arena->reference()));
                }
                return rows;
            });
        }
    }
    return all;
}

RowFormat<PrecisionRow> precision_format() {
    using Row = PrecisionRow;
    std::vector<std::string> scenes, methods, fixed;
    for (const PrecisionScene& scene : precision_scenes(false)) scenes.push_back(scene.name);
    for (const PrecisionMethod& method : precision_methods()) {
        methods.push_back(method.name);
        if (method.parameters.kind != IntegratorKind::DormandPrince) fixed.push_back(method.name);
    }
    const std::vector<std::string> measures{std::string(name_of(Measure::Position)),
                                            std::string(name_of(Measure::Overall))};
    const auto if_bounded = [](const Column& column) { return column.or_nan().where("end", {"unstable"}); };
    return {6,
            {{word_column("scene", scenes), &Row::scene},
             {whole_column("particles", 2), &Row::particles},
             {positive_column("stiffness_N_per_m"), &Row::stiffness},
             {positive_column("horizon_s"), &Row::horizon},
             {whole_column("phases", 1), &Row::phases},
             {word_column("method", methods), &Row::method},
             {positive_column("tolerance").or_words({""}).where("method", fixed), &Row::tolerance},
             {whole_column("steps", 1), &Row::steps},
             {positive_column("step_s"), &Row::step},
             {word_column("end", {"bounded", "unstable"}), &Row::end},
             {word_column("measure", measures), &Row::measure},
             {if_bounded(number_column("error")), &Row::error},
             {if_bounded(number_column("cost_lower_s_per_s")), &Row::cost_lower},
             {if_bounded(positive_column("cost_s_per_s")), &Row::cost},
             {if_bounded(number_column("cost_upper_s_per_s")), &Row::cost_upper},
             {number_column("reference_error"), &Row::reference_error},
             {number_column("growth").or_nan().or_words({"inf"}), &Row::growth}}};
}

}  // namespace

Experiment precision_experiment() {
    return ExperimentOf<PrecisionRow>{"precision",        "what does accuracy cost, by which method?",
                                      precision_format(), precision_cases,
                                      precision_charts,   precision_summary}
        .as_table();
}

}  // namespace drape
