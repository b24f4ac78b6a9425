#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>

#include "drape/base/input_error.h"
#include "drape/integrate/stability.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "precision.h"

namespace drape {
namespace {

using Pairs = std::vector<std::pair<double, double>>;

bool is_point(const Row& row) {
    return row.word("end") == "bounded" && std::isfinite(row.number("error")) &&
           std::isfinite(row.number("cost_s_per_s"));
}

/// Of the steps of a method that are shorter than any that was unstable.
std::optional<ObservedOrder> order_of(const Rows& method) {
    double shortest_unstable = std::numeric_limits<double>::infinity();
    for (const Row& row : method) {
        if (!is_point(row)) shortest_unstable = std::min(shortest_unstable, row.number("step_s"));
    }
    Pairs errors;
    for (const Row& row : method) {
        const double step = row.number("step_s");
        if (is_point(row) && step < shortest_unstable) errors.emplace_back(step, row.number("error"));
    }
    return observed_order(errors);
}

/// What the caption says of the reference of a scene, and of averages.
std::string caption_of(const Row& scene) {
    const double phases = scene.number("phases");
    const std::string averaged =
        phases == 1 ? ""
                    : fmt::format(
                          "Errors are averaged over {} phases of the first impact within a step; from that impact on, "
                          "every method is of order 1. ",
                          phases);
    return fmt::format("{}The reference is in error by {:.2g}; an error of {:.1g} m at the start grows {:.2g} times.",
                       averaged, scene.number("reference_error"), small_error, scene.number("growth"));
}

/// @param rows of one scene
/// @param points those of its rows that are drawn, at least one
Chart precision_chart(const Rows& rows, const Rows& points) {
    const Row& scene = points.front();
    Chart chart{"precision_" + scene.word("scene"), {}, "error,cost\n", "precision", caption_of(scene)};
    const auto methods = words_of(points, "method");
    for (const std::string& method : methods) {
        const auto order = order_of(rows_with(rows, "method", method));
        if (order) chart.values["order_" + method] = order->order;
    }
    for (const auto& [name, column] : {std::pair("error", "error"), std::pair("cost", "cost_s_per_s")}) {
        const auto [least, most] = std::ranges::minmax(points, {}, number_of(column));
        chart.values[std::string("least_") + name] = least.number(column);
        chart.values[std::string("most_") + name] = most.number(column);
    }
    chart.values.insert({{"scene", scene.word("scene")},
                         {"particles", scene.number("particles")},
                         {"stiffness", scene.number("stiffness_N_per_m")},
                         {"horizon", scene.number("horizon_s")},
                         {"overall", scene.word("measure") == name_of(Measure::Overall) ? 1. : 0.},
                         {"methods", in_words(methods)}});
    Pairs all;
    for (const Row& point : points) all.emplace_back(point.number("error"), point.number("cost_s_per_s"));
    for (const std::size_t k : pareto_front(all))
        chart.data += fmt::format("{:.6g},{:.6g}\n", all[k].first, all[k].second);
    return chart;
}

/// @param scene any of its rows
Chart choice_chart(const Row& scene) {
    return {"precision_choice_" + scene.word("scene"),
            {{"scene", scene.word("scene")},
             {"particles", scene.number("particles")},
             {"horizon", scene.number("horizon_s")}},
            {},
            "precision_choice"};
}

}  // namespace

std::vector<Chart> precision_charts(const Rows& rows) {
    std::vector<Chart> charts;
    for (const std::string& scene : words_of(rows, "scene")) {
        const Rows own = rows_with(rows, "scene", scene);
        Rows points = own;
        std::erase_if(points, [](const Row& row) { return !is_point(row); });
        if (points.empty()) continue;
        const double margin =
            std::ranges::min(points, {}, number_of("error")).number("error") / points.front().number("reference_error");
        if (!(margin >= least_margin)) {
            throw RunError(
                fmt::format("precision: the reference of the scene '{}' is only {:.3g} times better than "
                            "the best point, less than {:.3g}: no chart is drawn",
                            scene, margin, least_margin));
        }
        charts.push_back(precision_chart(own, points));
        charts.push_back(choice_chart(points.front()));
    }
    return charts;
}

namespace {

constexpr int timings_of_a_run = 7;

/// In the order of the table.
std::vector<Method> precision_methods() {
    return methods_named({"explicit_euler", "symplectic_euler", "velocity_verlet", "rk4", "dormand_prince",
                          "backward_euler", "implicit_midpoint_clamped", "implicit_midpoint_exact", "bdf2_clamped",
                          "bdf2_exact", "xpbd_1", "xpbd_5", "xpbd_20", "projective_dynamics_5",
                          "projective_dynamics_20"});
}

/// Just within a predicted limit of the step.
constexpr Real within_limit = Real(0.98);

/// Counts of steps, doubled from one to the next, and for a method with a step limit one just within it; with no ball,
/// Dormand-Prince has falling tolerances instead.
std::vector<Rung> ladder(const Method& method, const PrecisionScene& scene) {
    const IntegratorKind kind = method.parameters.kind;
    std::vector<Rung> rungs;
    if (kind == IntegratorKind::DormandPrince && !scene.has_ball()) {
        for (Real tolerance = Real(1e-2); tolerance > Real(0.9e-8); tolerance /= 10) {
            rungs.push_back({method.parameters, outer_steps});
            rungs.back().parameters.tolerance = tolerance;
        }
        return rungs;
    }
    int first = 8, last = scene.finest_steps;
    std::set<int> counts;
    if (has_step_limit(kind)) {
        const ClothParameters& cloth = scene.settings.cloths.front();
        const Real limit =
            predicted_limit(make_cloth_model(cloth), make_rest_state(cloth), kind, method.parameters.kernels).step;
        if (!scene.has_ball()) {
            // From the last steps beyond the limit at rest. Not far below its limit RK4 is as exact as the reference:
            // its ladder starts farther above
            const int too_long = kind == IntegratorKind::Rk4 ? 4 : 2;
            first = 1;
            while (scene.horizon / static_cast<Real>(first) > 2 * limit) first *= 2;
            first = std::max(first >> (too_long - 1), 1);
            last = first << (scene.rungs - 1);
        }
        const Real at_limit = std::ceil(scene.horizon / (within_limit * limit));
        if (at_limit < static_cast<Real>(last)) counts.insert(static_cast<int>(at_limit));
    }
    for (int steps = first; steps <= last; steps *= 2) counts.insert(steps);
    for (const int steps : counts) rungs.push_back({method.parameters, steps});
    return rungs;
}

/// The error of a rung is a mean over phases of the first impact.
Row row_of(const Method& method, const Rung& rung, const PrecisionScene& scene, const Reference& reference) {
    const ClothParameters& cloth = scene.settings.cloths.front();
    const ClothModel model = make_cloth_model(cloth);
    const bool adaptive = method.parameters.kind == IntegratorKind::DormandPrince;
    bool bounded = true;
    int steps = rung.steps;
    double squares = 0;
    for (int phase = 0; phase < scene.phases && bounded; ++phase) {
        const Real within =
            scene.has_ball() ? (static_cast<Real>(phase) + Real(0.5)) / static_cast<Real>(scene.phases) : 0;
        const Finish end = finish(scene, rung, within);
        const double error = error_of(reference.measure, model, end.state, reference.state, scene.side());
        squares += error * error;
        bounded = end.bounded;
        if (adaptive && !scene.has_ball()) steps = end.inner_steps;
    }
    return {{"scene", scene.name},
            {"particles", cloth.particles.nx},
            {"stiffness_N_per_m", cloth.structural.stiffness},
            {"horizon_s", scene.horizon},
            {"phases", scene.phases},
            {"method", method.name},
            {"tolerance", adaptive ? static_cast<double>(tolerance_of(rung.parameters)) : no_number},
            {"steps", steps},
            {"step_s", scene.horizon / static_cast<Real>(steps)},
            {"end", bounded ? "bounded" : "unstable"},
            {"measure", reference.measure},
            {"error", bounded ? std::sqrt(squares / scene.phases) : no_number},
            {"cost_s_per_s", bounded ? cost_of(scene, rung, timings_of_a_run) : no_quartiles},
            {"reference_error", reference.error},
            {"growth", reference.growth}};
}

ExperimentCases precision_cases(bool quick) {
    ExperimentCases all;
    for (const PrecisionScene& scene : precision_scenes(quick)) {
        // Found when the first case asks for it
        const auto reference = std::make_shared<std::optional<Reference>>();
        for (const Method& method : precision_methods()) {
            all.push_back([scene, reference, method] {
                if (!*reference) *reference = find_reference(scene);
                Rows rows;
                for (const Rung& rung : ladder(method, scene)) rows.push_back(row_of(method, rung, scene, **reference));
                return rows;
            });
        }
    }
    return all;
}

}  // namespace

Experiment precision_experiment() {
    return {"precision",
            "what does accuracy cost, by which method?",
            6,
            {word_column("scene", names_in(precision_scenes(false), &PrecisionScene::name)),
             whole_column("particles", 2), positive_column("stiffness_N_per_m"), positive_column("horizon_s"),
             whole_column("phases", 1), word_column("method", names_in(precision_methods(), &Method::name)),
             positive_column("tolerance").or_words({""}),  // of Dormand-Prince
             whole_column("steps", 1), positive_column("step_s"), word_column("end", {"bounded", "unstable"}),
             name_column<Measure>("measure"), number_column("error").or_nan(),
             number_column("cost_lower_s_per_s").or_nan(),  // CPU time of a simulated second
             positive_column("cost_s_per_s").or_nan(), number_column("cost_upper_s_per_s").or_nan(),
             number_column("reference_error"), number_column("growth").or_nan().or_words({"inf"})},  // of a small error
            {{"scene", "method", "end"}, {"step_s", "error", "cost_s_per_s", "reference_error", "growth"}},
            {{"", precision_cases, precision_charts}}};
}

}  // namespace drape
