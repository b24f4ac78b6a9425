#include "precision.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/input_error.h"

namespace drape {
namespace {

PrecisionCurve curve_of(const std::string& method, const Rows& rows) {
    PrecisionCurve curve{method, {}, {}};
    double shortest_unstable = std::numeric_limits<double>::infinity();
    for (const Row& row : rows) {
        const bool is_point = row.word("end") == "bounded" && std::isfinite(row.number("error")) &&
                              std::isfinite(row.number("cost_s_per_s"));
        if (is_point) curve.points.push_back(row);
        if (!is_point) shortest_unstable = std::min(shortest_unstable, row.number("step_s"));
    }
    std::vector<std::pair<double, double>> errors;
    for (const Row& point : curve.points) {
        if (point.number("step_s") < shortest_unstable) {
            errors.emplace_back(point.number("step_s"), point.number("error"));
        }
    }
    curve.order = observed_order(errors);
    return curve;
}

/// @param rows of one scene, at least one
PrecisionDiagram diagram_of(const Rows& rows) {
    PrecisionDiagram diagram{rows.front(), {}, {}};
    Rows all;
    std::vector<std::pair<double, double>> pairs;
    for (const std::string& method : words_of(rows, "method")) {
        diagram.curves.push_back(curve_of(method, rows_with(rows, "method", method)));
        for (const Row& point : diagram.curves.back().points) {
            all.push_back(point);
            pairs.emplace_back(point.number("error"), point.number("cost_s_per_s"));
        }
    }
    for (const std::size_t i : pareto_front(pairs)) diagram.front.push_back(all[i]);
    return diagram;
}

std::string caption_of(const Row& scene) {
    const double phases = scene.number("phases");
    const std::string averaged =
        phases == 1 ? ""
                    : fmt::format(
                          " Errors are averaged over {} phases of the first impact within a step; from that impact on, "
                          "every method is of order 1.",
                          phases);
    return fmt::format(
        "Error at the horizon against the CPU time of a simulated second (medians, quartiles as bars) "
        "over a ladder of steps: left is more exact, down is cheaper. The order is fitted to the finest "
        "points.{} The reference is in error by {:.2g}; an error of {:.1g} m at the start grows {:.2g} "
        "times.",
        averaged, scene.number("reference_error"), small_error, scene.number("growth"));
}

Chart precision_chart(const PrecisionDiagram& diagram) {
    const Row& scene = diagram.scene;
    Rows points;
    std::vector<std::string> methods;
    Chart chart{"precision_" + scene.word("scene"), "precision", caption_of(scene), {}, "error,cost\n"};
    for (const PrecisionCurve& curve : diagram.curves) {
        if (curve.points.empty()) continue;
        methods.push_back(curve.method);
        points.insert(points.end(), curve.points.begin(), curve.points.end());
        if (curve.order) chart.values["order_" + curve.method] = curve.order->order;
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
    for (const Row& point : diagram.front) {
        chart.data += fmt::format("{:.6g},{:.6g}\n", point.number("error"), point.number("cost_s_per_s"));
    }
    return chart;
}

/// @param scene any of its rows
Chart choice_chart(const Row& scene) {
    return {"precision_choice_" + scene.word("scene"),
            "precision_choice",
            "Six of these methods: what each error costs, and which errors a picture can show.",
            {{"scene", scene.word("scene")},
             {"particles", scene.number("particles")},
             {"horizon", scene.number("horizon_s")}}};
}

}  // namespace

double PrecisionDiagram::margin() const {
    double least = std::numeric_limits<double>::infinity();
    for (const Row& point : front) least = std::min(least, point.number("error"));
    return least / scene.number("reference_error");
}

std::vector<PrecisionDiagram> precision_diagrams(const Rows& rows) {
    std::vector<PrecisionDiagram> diagrams;
    for (const std::string& scene : words_of(rows, "scene")) {
        diagrams.push_back(diagram_of(rows_with(rows, "scene", scene)));
    }
    return diagrams;
}

std::vector<Chart> precision_charts(const Rows& rows) {
    std::vector<Chart> charts;
    for (const PrecisionDiagram& diagram : precision_diagrams(rows)) {
        if (!(diagram.margin() >= least_margin)) {
            throw RunError(
                fmt::format("precision: the reference of the scene '{}' is only {:.3g} times better than "
                            "the best point, less than {:.3g}: no chart is drawn",
                            diagram.scene.word("scene"), diagram.margin(), least_margin));
        }
        if (diagram.front.empty()) continue;
        charts.push_back(precision_chart(diagram));
        charts.push_back(choice_chart(diagram.scene));
    }
    return charts;
}

}  // namespace drape
