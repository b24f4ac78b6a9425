#pragma once

#include "contact_solver.h"

namespace drape {

/// Pushes by springs and dampers at the contacts that take part.
Sweeps solve_penalties(ContactProblem& problem, IsActive active);

}  // namespace drape
