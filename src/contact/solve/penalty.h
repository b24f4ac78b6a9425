#pragma once

#include "sweeps.h"

namespace drape {

/// Pushes by springs and dampers at the chosen contacts.
Sweeps solve_penalties(ContactProblem& problem);

/// A contact that penalties answer: it has entered.
inline bool has_entered(const ContactRow& row) { return row.depth > 0; }

}  // namespace drape
