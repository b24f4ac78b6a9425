#include "problem.h"

#include <algorithm>

// Positions are projected out of balls and ground @cite provot1995, each contact by the least displacement of its
// particles, and held against sliding by friction; then the velocities of those that were pushed are stopped, or
// thrown back. What the projection moves does not become velocity.

namespace drape {
namespace {

/// The push that a contact still asks for, as a fraction of its ball's radius. Planes do not turn.
Real length_of_push(const ContactProblem& problem, const ContactRow& row) {
    if (row.kind == RowKind::Bodies || row.body == no_body || !problem.body(row.body).is_ball()) return 0;
    return correction_of(row, problem.bodies) / problem.body(row.body).radius;
}

/// Displaces until all contacts are out and hold.
Sweeps project_positions(ContactProblem& problem) {
    ContactMotion& motion = problem.scratch.displacements;
    Sweeps all;
    for (int round = 0; round < max_rounds; ++round) {
        Real longest = 0;
        for_each_row(
            problem, [&](ContactRow & row, RowState & state) __attribute__((flatten)) {
                // How far the contact must come along its normal within the substep to be out
                target_of(state, Quantity::Displacement) =
                    relative(problem, motion, row, state).dot(row.normal) + correction_of(row, problem.bodies);
                longest = std::max(longest, length_of_push(problem, row));
                state.active = state.can_move();
            });
        const Sweeps sweeps = solve(problem, motion);
        all = {all.count + sweeps.count, sweeps.residual};
        if (longest <= short_push) break;
        for_each_row(problem, [&](ContactRow& row, RowState& state) { find_again(problem, row, state); });
    }
    return all;
}

}  // namespace

Sweeps respond_by_projection(ContactProblem& problem) {
    const Sweeps displaced = project_positions(problem);
    // Contacts that carry nothing, and were given nothing, are free to part, and to meet in a later step
    choose(problem, [](const ContactRow& row, const RowState&) {
        return row.displacement.normal > 0 || row.impulse.normal > 0;
    });
    const Sweeps stopped = solve(problem, problem.scratch.velocities);
    return {displaced.count + stopped.count, displaced.residual};
}

}  // namespace drape
