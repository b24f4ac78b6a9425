#pragma once

#include "sweeps.h"

namespace drape {

/// Orders the rows so that neighbours share no particle where that can be, and have equally many: a processor then
/// solves several at a time. Results have the bits of any order in which contacts that share a particle keep theirs.
/// Leaves the order empty where plain code is to solve: if that is asked for, or where contacts push a body, which they
/// share.
void order_rows(ContactProblem& problem);

/// `solve` over compact rows in that order, with the bits of the plain code.
Sweeps solve_compact(ContactProblem& problem, ContactMotion& motion, Real tolerance);

}  // namespace drape
