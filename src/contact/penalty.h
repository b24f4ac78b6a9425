#pragma once

#include "contact_solver.h"

namespace drape {

/// Pushes by springs and dampers at the contacts that take part.
Sweeps solve_penalties(ContactProblem& problem, bool (*takes_part)(const ContactProblem&, const ContactPlane&));

}  // namespace drape
