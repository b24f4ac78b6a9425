#include <algorithm>

#include "drape/base/numbers.h"
#include "precision_diagram.h"
#include "precision_experiment.h"
#include "reference.h"

namespace drape {
namespace {

std::string text(double value) { return real_text(value, 3); }

/// What the errors of a scene are worth.
std::string worth(const PrecisionDiagram& diagram) {
    const std::string side = real_text(diagram.particles);
    std::string line = diagram.scene + ": " + side + " x " + side + " particles, " + real_text(diagram.stiffness) +
                       " N/m, to " + real_text(diagram.horizon) + " s\n  an error of " + text(small_error) +
                       " m at the start grows " + text(diagram.growth) + " times";
    if (diagram.measure != name_of(Measure::Position)) {
        line += ": more than " + text(most_growth) +
                ", so positions at this horizon are not compared; sag, centre of mass and energy are";
    }
    line += "\n  reference: its own error is " + text(diagram.reference_error) + ", the best point's " +
            text(diagram.margin()) + " times that";
    if (!(diagram.margin() >= least_margin)) line += ": less than " + text(least_margin) + ", no chart is drawn";
    return line + "\n";
}

std::string about(const PrecisionCurve& curve) {
    std::string line = "  " + curve.method.name + ": ";
    const auto& points = curve.points;
    if (curve.order) {
        const auto& coarse = points[points.size() - curve.order->points];
        line += "order " + text(curve.order->order) + " over the finest " + std::to_string(curve.order->points) +
                " points (" + text(coarse.step) + " to " + text(points.back().step) + " s)";
    } else {
        line += "no order (the error follows no power over 3 points)";
    }
    if (!points.empty()) {
        const auto [least, most] = std::ranges::minmax(points, {}, &PrecisionPoint::error);
        line += ", error " + text(least.error) + " to " + text(most.error);
    }
    if (!curve.unstable.empty()) line += ", unstable at";
    for (const double step : curve.unstable) line += " " + text(step);
    return line + (curve.unstable.empty() ? "\n" : " s\n");
}

}  // namespace

std::string precision_summary(const std::vector<TableRow>& rows) {
    std::string all;
    for (const PrecisionDiagram& diagram : precision_diagrams(rows)) {
        all += worth(diagram);
        for (const PrecisionCurve& curve : diagram.curves) all += about(curve);
        all += "  nothing is both more exact and cheaper than\n";
        for (const PrecisionPoint& point : diagram.front) {
            all += "    " + point.method + " at " + text(point.step) + " s: error " + text(point.error) + ", " +
                   text(point.cost) + " s/s\n";
        }
    }
    return all;
}

}  // namespace drape
