#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/experiment/experiment.h"
#include "lab/measure/fits.h"

namespace drape {

/// One method at one step on one scene.
struct PrecisionRow {
    std::string scene;
    double particles = 0, stiffness = 0, horizon = 0, phases = 0;  ///< of the scene [1, N/m, s, 1]
    std::string method;
    double tolerance = 0;                             ///< of Dormand-Prince; nan for others
    double steps = 0, step = 0;                       ///< how many, and how long [s]
    std::string end, measure;                         ///< bounded or unstable; what the error is of
    double error = 0;                                 ///< nan where it was unstable, as are the costs
    double cost_lower = 0, cost = 0, cost_upper = 0;  ///< CPU time for a simulated second [s]
    double reference_error = 0, growth = 0;           ///< of the reference
};

/// One method's points, from coarse to fine.
struct PrecisionCurve {
    std::string method;
    std::vector<PrecisionRow> points;
    std::vector<double> unstable;  ///< steps that did not stay bounded [s]
    std::optional<ObservedOrder> order;
};

/// What the rows of one scene say.
struct PrecisionDiagram {
    PrecisionRow scene;                  ///< one of its rows: scene, measure and reference are the same in all
    std::vector<PrecisionCurve> curves;  ///< in the order of the table
    std::vector<PrecisionRow> front;     ///< points that no other one beats, from exact to cheap

    /// The least error of any point over that of the reference; infinite without points.
    [[nodiscard]] double margin() const;
};

/// In the order in which the scenes come.
std::vector<PrecisionDiagram> precision_diagrams(const std::vector<PrecisionRow>& rows);

/// A work-precision diagram a scene.
/// @throws RunError if the reference of a scene is not two decades better than the best point: nothing is drawn then
std::vector<Chart> precision_charts(const std::vector<PrecisionRow>& rows);

/// What the reference is worth, order and unstable steps of each method, and which points no other one beats.
std::string precision_summary(const std::vector<PrecisionRow>& rows);

}  // namespace drape
