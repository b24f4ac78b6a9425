#pragma once

#include <vector>

#include "lab/experiment/experiment.h"

namespace drape {

/// Every experiment of the laboratory.
std::vector<Experiment> all_experiments();

}  // namespace drape
