#include "precision_diagram.h"

#include <algorithm>
#include <limits>

#include "lab/measure/pareto_front.h"
#include "precision_experiment.h"

namespace drape {
namespace {

namespace at = precision_column;

using Pairs = std::vector<std::pair<double, double>>;

PrecisionCurve curve_of(const PrecisionMethod& method, const std::vector<TableRow>& rows) {
    PrecisionCurve curve{method, {}, {}, {}};
    for (const TableRow& row : rows) {
        if (row[at::Method] != method.name) continue;
        const double step = number_in(row[at::Step]);
        if (row[at::End] == "bounded") {
            curve.points.push_back({method.name, step, number_in(row[at::Error]), number_in(row[at::Cost])});
        } else {
            curve.unstable.push_back(step);
        }
    }
    Pairs errors;
    for (const PrecisionPoint& point : curve.points) {
        const bool finer = std::ranges::all_of(curve.unstable, [&point](double step) { return point.step < step; });
        if (finer) errors.emplace_back(point.step, point.error);
    }
    curve.order = observed_order(errors);
    return curve;
}

/// @param rows of one scene, at least one
PrecisionDiagram diagram_of(const std::vector<TableRow>& rows) {
    const TableRow& first = rows.front();
    PrecisionDiagram diagram{.scene = first[at::Scene],
                             .measure = first[at::Measured],
                             .particles = number_in(first[at::Particles]),
                             .stiffness = number_in(first[at::Stiffness]),
                             .horizon = number_in(first[at::Horizon]),
                             .phases = number_in(first[at::Phases]),
                             .reference_error = number_in(first[at::ReferenceError]),
                             .growth = number_in(first[at::Growth]),
                             .curves = {},
                             .front = {}};
    std::vector<PrecisionPoint> all;
    Pairs pairs;
    for (const PrecisionMethod& method : precision_methods()) {
        PrecisionCurve curve = curve_of(method, rows);
        for (const PrecisionPoint& point : curve.points) {
            all.push_back(point);
            pairs.emplace_back(point.error, point.cost);
        }
        if (!curve.points.empty() || !curve.unstable.empty()) diagram.curves.push_back(std::move(curve));
    }
    for (const std::size_t i : pareto_front(pairs)) diagram.front.push_back(all[i]);
    return diagram;
}

}  // namespace

double PrecisionDiagram::margin() const {
    double least = std::numeric_limits<double>::infinity();
    for (const PrecisionPoint& point : front) least = std::min(least, point.error);
    return least / reference_error;
}

std::vector<PrecisionDiagram> precision_diagrams(const std::vector<TableRow>& rows) {
    std::vector<std::vector<TableRow>> scenes;
    for (const TableRow& row : rows) {
        const auto same = [&row](const auto& scene) { return scene.front()[at::Scene] == row[at::Scene]; };
        const auto found = std::ranges::find_if(scenes, same);
        (found == scenes.end() ? scenes.emplace_back() : *found).push_back(row);
    }
    std::vector<PrecisionDiagram> diagrams;
    for (const auto& scene : scenes) diagrams.push_back(diagram_of(scene));
    return diagrams;
}

}  // namespace drape
