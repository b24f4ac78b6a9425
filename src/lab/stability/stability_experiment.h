#pragma once

#include "lab/experiment/experiment.h"

namespace drape {

/// Which steps stay bounded under which method, over stiffness and damping, beside the predicted limit.
Experiment stability_experiment();

}  // namespace drape
