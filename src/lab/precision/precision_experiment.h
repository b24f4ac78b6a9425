#pragma once

#include "lab/experiment/experiment.h"

namespace drape {

/// What accuracy costs: the error of each method at a horizon against its time, over a ladder of steps.
Experiment precision_experiment();

/// A work-precision diagram a scene, of the rows of that experiment.
/// @throws RunError if the reference of a scene is not two decades better than the best point: nothing is drawn then
std::vector<Chart> precision_charts(const std::vector<TableRow>& rows);

/// Of the same rows: what the reference is worth, order and unstable steps of each method, and which points nothing
/// beats.
std::string precision_summary(const std::vector<TableRow>& rows);

/// The columns of its table, by name.
namespace precision_column {
enum : std::size_t {
    Scene,
    Particles,
    Stiffness,
    Horizon,
    Phases,
    Method,
    Tolerance,
    Steps,
    Step,
    End,
    Measured,
    Error,
    CostLower,
    Cost,
    CostUpper,
    ReferenceError,
    Growth
};
}

}  // namespace drape
