#include "problem.h"

#include <algorithm>
#include <cmath>

// One impulse per impact changes velocities at its time, and moves positions by that change over the rest of the
// substep @cite mirtich1995. What is still inside after that, and what rests, is projected: impulses that put back what
// has entered would make resting cloth quiver.

namespace drape {
namespace {

/// How fast gravity makes the approach of two sides grow [m/s^2]: not at all where both fall, or where it draws them
/// apart. Cloth counts as falling where it may fall onto what it meets: what its springs add within a substep is not
/// known, but cloth beside or below a ball hangs in them.
Real growth_of_approach(const ContactProblem& problem, const ContactRow& row) {
    const auto falls = [&](int body) { return body == no_body || problem.body(body).inverse_mass > 0; };
    const Real downwards = -problem.gravity.dot(row.normal);
    return std::max(downwards * Real(falls(row.first_body) - falls(row.body)), Real(0));
}

/// Sets how much of the substep is left after the impact, and the velocity at which the sides part at the end of the
/// substep. Depth and approach are those of the end: gravity has made the approach grow since the impact, and slows the
/// rebound by the same amount. What would land again within the substep stops instead.
void time_impact(const ContactProblem& problem, const ContactRow& row, RowState& state) {
    const Real depth = std::max(correction_of(row, problem.bodies), Real(0));
    const Real growth = growth_of_approach(problem, row), at_end = state.approach;
    const Real at_impact = std::sqrt(std::max(at_end * at_end - 2 * growth * depth, Real(0)));
    const Real remaining = std::min(problem.h, 2 * depth / (at_end + at_impact)), grown = growth * remaining;
    const Real parting = state.surface.restitution * (at_end - grown) - grown;
    const bool parts = parting > 0;
    target_of(state, Quantity::Velocity) = parts ? parting : Real(0);
    state.remaining = parts ? remaining : std::min(problem.h, depth / at_end);
}

/// Moves what impulses have changed by that over the rest of the substep.
/// @param sign -1 before the impulses are given, 1 after
void displace(ContactProblem& problem, Real sign) {
    for_each_chosen(problem, [&](const ContactRow& row, const RowState& state) {
        apply_impulse(problem, problem.scratch.displacements, row, state,
                      sign * state.remaining * row.impulse.about(row.normal));
    });
}

}  // namespace

Sweeps respond_by_impulses(ContactProblem& problem) {
    choose(problem,
           [&](const ContactRow& row, const RowState& state) { return row.depth > 0 && is_impact(problem, state); });
    bool any = false;
    for_each_chosen(problem, [&](const ContactRow& row, RowState& state) {
        time_impact(problem, row, state);
        any = true;
    });
    if (!any) return {};
    displace(problem, -1);
    const Sweeps sweeps = solve(problem, problem.scratch.velocities);
    displace(problem, 1);
    return {sweeps.count, sweeps.residual * problem.h};
}

}  // namespace drape
