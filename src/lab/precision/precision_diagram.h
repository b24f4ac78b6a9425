#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/experiment/experiment.h"
#include "lab/measure/observed_order.h"
#include "precision_methods.h"

namespace drape {

/// A point of a curve: what a step costs and how wrong it is.
struct PrecisionPoint {
    std::string method;
    double step, error, cost;  ///< s, 1, s/s
};

/// One method's points, from coarse to fine.
struct PrecisionCurve {
    PrecisionMethod method;
    std::vector<PrecisionPoint> points;
    std::vector<double> unstable;  ///< steps that did not stay bounded [s]
    std::optional<ObservedOrder> order;
};

/// What the rows of one scene say.
struct PrecisionDiagram {
    std::string scene, measure;
    double particles = 0, stiffness = 0, horizon = 0, phases = 0;
    double reference_error = 0, growth = 0;
    std::vector<PrecisionCurve> curves;  ///< in the order of `precision_methods`; only those that have rows
    std::vector<PrecisionPoint> front;   ///< that no other point beats, from exact to cheap

    /// The least error of any point over that of the reference; infinite without points.
    [[nodiscard]] double margin() const;
};

/// In the order in which the scenes come.
std::vector<PrecisionDiagram> precision_diagrams(const std::vector<TableRow>& rows);

}  // namespace drape
