#pragma once

#include "lab/experiment/experiment.h"

namespace drape {

/// What accuracy costs: the error of each method at a horizon against its time, over a ladder of steps.
Experiment precision_experiment();

}  // namespace drape
