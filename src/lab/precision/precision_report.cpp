#include "precision.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/input_error.h"

namespace drape {
namespace {

PrecisionCurve curve_of(const std::string& method, const std::vector<PrecisionRow>& rows) {
    PrecisionCurve curve{method, {}, {}, {}};
    for (const PrecisionRow& row : rows) {
        const bool is_point = row.end == "bounded" && std::isfinite(row.error) && std::isfinite(row.cost.median);
        if (is_point) curve.points.push_back(row);
        if (!is_point) curve.unstable.push_back(row.step);
    }
    std::vector<std::pair<double, double>> errors;
    for (const PrecisionRow& point : curve.points) {
        const bool below = std::ranges::all_of(curve.unstable, [&point](double step) { return point.step < step; });
        if (below) errors.emplace_back(point.step, point.error);
    }
    curve.order = observed_order(errors);
    return curve;
}

/// @param rows of one scene, at least one
PrecisionDiagram diagram_of(const std::vector<PrecisionRow>& rows) {
    PrecisionDiagram diagram{rows.front(), {}, {}};
    std::vector<PrecisionRow> all;
    std::vector<std::pair<double, double>> pairs;
    for (const std::string& method : words_of(rows, &PrecisionRow::method)) {
        diagram.curves.push_back(curve_of(method, rows_with(rows, &PrecisionRow::method, method)));
        for (const PrecisionRow& point : diagram.curves.back().points) {
            all.push_back(point);
            pairs.emplace_back(point.error, point.cost.median);
        }
    }
    for (const std::size_t i : pareto_front(pairs)) diagram.front.push_back(all[i]);
    return diagram;
}

std::string caption_of(const PrecisionRow& scene) {
    const std::string phases = scene.phases == 1
                                   ? ""
                                   : fmt::format(
                                         " Errors are averaged over {} phases of the first impact within a step; from "
                                         "that impact on, every method is of order 1.",
                                         scene.phases);
    return fmt::format(
        "Error at the horizon against the CPU time of a simulated second (medians, quartiles as bars) "
        "over a ladder of steps: left is more exact, down is cheaper. The order is fitted to the finest "
        "points.{} The reference is in error by {:.2g}; an error of {:.1g} m at the start grows {:.2g} "
        "times.",
        phases, scene.reference_error, small_error, scene.growth);
}

Chart precision_chart(const PrecisionDiagram& diagram) {
    const PrecisionRow& scene = diagram.scene;
    std::vector<PrecisionRow> points;
    std::vector<std::string> methods;
    Chart chart{"precision_" + scene.scene, "precision", caption_of(scene), {}, "error,cost\n"};
    for (const PrecisionCurve& curve : diagram.curves) {
        if (curve.points.empty()) continue;
        methods.push_back(curve.method);
        points.insert(points.end(), curve.points.begin(), curve.points.end());
        if (curve.order) chart.values["order_" + curve.method] = curve.order->order;
    }
    const auto [exact, wrong] = std::ranges::minmax(points, {}, &PrecisionRow::error);
    const auto [cheap, expensive] =
        std::ranges::minmax(points, {}, [](const auto& point) { return point.cost.median; });
    chart.values.insert({{"scene", scene.scene},
                         {"particles", scene.particles},
                         {"stiffness", scene.stiffness},
                         {"horizon", scene.horizon},
                         {"overall", scene.measure == name_of(Measure::Overall) ? 1. : 0.},
                         {"methods", in_words(methods)},
                         {"least_error", exact.error},
                         {"most_error", wrong.error},
                         {"least_cost", cheap.cost.median},
                         {"most_cost", expensive.cost.median}});
    for (const PrecisionRow& point : diagram.front)
        chart.data += fmt::format("{:.6g},{:.6g}\n", point.error, point.cost.median);
    return chart;
}

/// @param scene any of its rows
Chart choice_chart(const PrecisionRow& scene) {
    return {"precision_choice_" + scene.scene,
            "precision_choice",
            "Six of these methods: what each error costs, and which errors a picture can show.",
            {{"scene", scene.scene}, {"particles", scene.particles}, {"horizon", scene.horizon}}};
}

}  // namespace

double PrecisionDiagram::margin() const {
    double least = std::numeric_limits<double>::infinity();
    for (const PrecisionRow& point : front) least = std::min(least, point.error);
    return least / scene.reference_error;
}

std::vector<PrecisionDiagram> precision_diagrams(const std::vector<PrecisionRow>& rows) {
    std::vector<PrecisionDiagram> diagrams;
    for (const std::string& scene : words_of(rows, &PrecisionRow::scene)) {
        diagrams.push_back(diagram_of(rows_with(rows, &PrecisionRow::scene, scene)));
    }
    return diagrams;
}

std::vector<Chart> precision_charts(const std::vector<PrecisionRow>& rows) {
    std::vector<Chart> charts;
    for (const PrecisionDiagram& diagram : precision_diagrams(rows)) {
        if (!(diagram.margin() >= least_margin)) {
            throw RunError(
                fmt::format("precision: the reference of the scene '{}' is only {:.3g} times better than "
                            "the best point, less than {:.3g}: no chart is drawn",
                            diagram.scene.scene, diagram.margin(), least_margin));
        }
        if (diagram.front.empty()) continue;
        charts.push_back(precision_chart(diagram));
        charts.push_back(choice_chart(diagram.scene));
    }
    return charts;
}

}  // namespace drape
