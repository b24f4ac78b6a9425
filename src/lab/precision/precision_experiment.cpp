#include "precision_experiment.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "drape/base/numbers.h"
#include "drape/integrate/stability.h"
#include "precision_methods.h"
#include "precision_run.h"
#include "reference.h"

namespace drape {
namespace {

constexpr int repeats = 7;

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
        const Real limit =
            predicted_limit(make_cloth_model(cloth), make_rest_state(cloth), method.parameters.kind).step;
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

TableRow row_of(const PrecisionMethod& method, const Rung& rung, const PrecisionScene& scene,
                const Reference& reference) {
    const Outcome outcome = outcome_of(rung, scene, reference);
    const bool adaptive = method.parameters.kind == IntegratorKind::DormandPrince;
    const int steps = adaptive && !scene.has_ball() ? outcome.inner_steps : rung.steps;
    const auto text = [](auto value) { return real_text(static_cast<double>(value), 6); };
    TableRow row{scene.name,
                 std::to_string(scene.settings.cloths.front().particles.nx),
                 text(scene.settings.cloths.front().structural.stiffness),
                 text(scene.horizon),
                 std::to_string(scene.phases),
                 method.name,
                 adaptive ? text(rung.parameters.tolerance) : "",
                 std::to_string(steps),
                 text(scene.horizon / static_cast<Real>(steps)),
                 outcome.bounded ? "bounded" : "unstable",
                 std::string(name_of(reference.measure))};
    if (outcome.bounded) {
        const Quartiles cost = cost_of(scene, rung.parameters, rung.steps, repeats);
        for (const double value : {outcome.error, cost.lower, cost.median, cost.upper}) row.push_back(text(value));
    } else {
        row.insert(row.end(), 4, "nan");
    }
    row.push_back(text(reference.error));
    row.push_back(text(reference.growth));
    return row;
}

std::vector<ExperimentCase> cases(bool quick) {
    std::vector<ExperimentCase> all;
    for (PrecisionScene& scene : precision_scenes(quick)) {
        const auto arena = std::make_shared<Arena>(std::move(scene));
        for (const PrecisionMethod& method : precision_methods()) {
            all.push_back([arena, method] {
                std::vector<TableRow> rows;
                for (const Rung& rung : ladder(method, arena->scene())) {
                    rows.push_back(row_of(method, rung, arena->scene(), arena->reference()));
                }
                return rows;
            });
        }
    }
    return all;
}

std::vector<Column> columns() {
    std::vector<std::string> scenes, methods, fixed;
    for (const PrecisionScene& scene : precision_scenes(false)) scenes.push_back(scene.name);
    for (const PrecisionMethod& method : precision_methods()) {
        methods.push_back(method.name);
        if (method.parameters.kind != IntegratorKind::DormandPrince) fixed.push_back(method.name);
    }
    const auto if_bounded = [](const Column& column) { return column.or_nan().where("end", {"unstable"}); };
    return {word_column("scene", scenes),
            whole_column("particles", 2),
            positive_column("stiffness_N_per_m"),
            positive_column("horizon_s"),
            whole_column("phases", 1),
            word_column("method", methods),
            positive_column("tolerance").or_words({""}).where("method", fixed),
            whole_column("steps", 1),
            positive_column("step_s"),
            word_column("end", {"bounded", "unstable"}),
            word_column("measure", {std::string(name_of(Measure::Position)), std::string(name_of(Measure::Overall))}),
            if_bounded(number_column("error")),
            if_bounded(number_column("cost_lower_s_per_s")),
            if_bounded(positive_column("cost_s_per_s")),
            if_bounded(number_column("cost_upper_s_per_s")),
            number_column("reference_error"),
            number_column("growth").or_nan().or_words({"inf"})};
}

}  // namespace

Experiment precision_experiment() {
    return {"precision",      "what does accuracy cost, by which method?", columns(), cases, precision_charts,
            precision_summary};
}

}  // namespace drape
