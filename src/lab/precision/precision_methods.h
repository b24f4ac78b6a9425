#pragma once

#include <string>
#include <vector>

#include "drape/integrate/integrator.h"

namespace drape {

/// A method with its variant, as it takes part in a work-precision diagram.
struct PrecisionMethod {
    std::string name;   ///< in the table
    std::string title;  ///< in charts
    IntegratorParameters parameters;
    int panel = 0;     ///< of the chart that it is drawn in: 0 explicit, 1 implicit, 2 positional
    int too_long = 2;  ///< with a step limit: steps beyond it that are tried
};

/// All of them, in the order of table and chart.
const std::vector<PrecisionMethod>& precision_methods();

}  // namespace drape
