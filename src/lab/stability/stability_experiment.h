#pragma once

#include "lab/experiment/experiment.h"

namespace drape {

/// Which steps stay bounded under which method, over stiffness and damping, beside the predicted limit.
Experiment stability_experiment();

/// A chart a method, of the rows of that experiment.
std::vector<Chart> stability_charts(const std::vector<TableRow>& rows);

/// The columns of its table, by name.
namespace stability_column {
enum : std::size_t {
    Method,
    Sweep,
    Side,
    Stiffness,
    Damping,
    Omega,
    Zeta,
    Predicted,
    Expected,
    Measured,
    Step,
    End,
    Verdict
};
}

}  // namespace drape
