#include "precision_diagram.h"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

using Pairs = std::vector<std::pair<double, double>>;

PrecisionCurve curve_of(const std::string& method, const std::vector<PrecisionRow>& rows) {
    PrecisionCurve curve{method, {}, {}, {}};
    for (const PrecisionRow& row : rows) {
        if (row.end == "bounded") {
            curve.points.push_back(row);
        } else {
            curve.unstable.push_back(row.step);
        }
    }
    Pairs errors;
    for (const PrecisionRow& point : curve.points) {
        const bool finer = std::ranges::all_of(curve.unstable, [&point](double step) { return point.step < step; });
        if (finer) errors.emplace_back(point.step, point.error);
    }
    curve.order = observed_order(errors);
    return curve;
}

/// @param rows of one scene, at least one
PrecisionDiagram diagram_of(const std::vector<PrecisionRow>& rows) {
    PrecisionDiagram diagram{rows.front(), {}, {}};
    std::vector<PrecisionRow> all;
    Pairs pairs;
    for (const std::string& method : words_of(rows, &PrecisionRow::method)) {
        diagram.curves.push_back(curve_of(method, rows_with(rows, &PrecisionRow::method, method)));
        for (const PrecisionRow& point : diagram.curves.back().points) {
            all.push_back(point);
            pairs.emplace_back(point.error, point.cost);
        }
    }
    for (const std::size_t i : pareto_front(pairs)) diagram.front.push_back(all[i]);
    return diagram;
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

}  // namespace drape
