#pragma once

#include <algorithm>
#include <cmath>

#include "problem.h"

namespace drape {

/// What came of sweeps.
struct Sweeps {
    int count = 0;
    Real residual = 0;  ///< largest change of a contact's motion in the last one [m or m/s]
};

/// Chooses the contacts that a solve is about, of those in the response under way.
/// @param chooses chooses(row, state)
template <class Chooses>
void choose(ContactProblem& problem, Chooses chooses) {
    for_each_row(problem, [&](const ContactRow& row, RowState& state) {
        state.active = state.inverse_mass > 0 && chooses(row, state);
    });
}

/// Calls visit(row, state) for these.
template <class Visit>
void for_each_chosen(const ContactProblem& problem, Visit visit) {
    for_each_row(problem, [&](ContactRow& row, RowState& state) {
        if (state.active) visit(row, state);
    });
}

/// Solves the chosen contacts one after the other, again and again, until none changes by more than a tolerance: of
/// displacements, a small part of what gravity moves a particle by within a step or, if more, of the thickness between
/// cloths that touch, or the last digits of a metre; of velocities, what that is within a step, but between cloths no
/// more than what is seen as rest.
[[nodiscard]] Sweeps solve(ContactProblem& problem, ContactMotion& motion);

/// The same where impulses along the normals are fixed: friction alone.
[[nodiscard]] Sweeps solve_friction(ContactProblem& problem, ContactMotion& motion);

/// Gives impulses to the contacts that are impacts.
Sweeps solve_impacts(ContactProblem& problem);

/// Pushes by springs and dampers at the chosen contacts, which have entered.
Sweeps solve_penalties(ContactProblem& problem);

/// Orders the rows so that neighbours share no particle where that can be, and have equally many: a processor then
/// solves several at a time. Results have the bits of any order in which contacts that share a particle keep theirs.
/// Leaves the order empty where plain code is to solve: if that is asked for, or where contacts push a body, which they
/// share.
void order_rows(ContactProblem& problem);

/// `solve` over compact rows in that order, with the bits of the plain code.
Sweeps solve_compact(ContactProblem& problem, ContactMotion& motion, Real tolerance);

namespace kernels {

/// One sweep of `solve` over compact rows, with the bits of the plain code.
/// @param motion of the particles
/// @return the square of the largest change
Real sweep_rows(std::span<Real4> motion, std::span<CompactRow> rows);

}  // namespace kernels

/// Repeats a sweep until nothing changes by more than the tolerance.
/// @param sweep sweep() returns the square of the largest change
template <class Sweep>
Sweeps sweep_until(Real tolerance, Sweep sweep) {
    Sweeps sweeps;
    Real square = 0;
    do {
        square = sweep();
        ++sweeps.count;
    } while (square > tolerance * tolerance && sweeps.count < max_sweeps);
    sweeps.residual = std::sqrt(square);
    return sweeps;
}

}  // namespace drape
