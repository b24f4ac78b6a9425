#pragma once

#include "lab/experiment/experiment.h"

namespace drape {

/// Time of the hierarchy's build and query against how well it tells what touches, on recorded motions: by volume,
/// sphere fit, update and leaf size, by level, by the budget of a search, over frames, and by the number of particles.
/// Every query is checked against brute force; a disagreement ends the run.
Experiment hierarchy_experiment();

}  // namespace drape
