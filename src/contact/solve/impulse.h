#pragma once

#include "sweeps.h"

namespace drape {

/// Gives impulses to the contacts that are impacts.
Sweeps solve_impacts(ContactProblem& problem);

}  // namespace drape
