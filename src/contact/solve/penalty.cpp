#include "problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drape/base/exact_math.h"

// Each contact is a spring of its depth and a damper of its approach @cite moore1988, which push but never pull. The
// damping ratio is that of a spring after which a bounce keeps the restitution of its speed. As springs they have a
// step limit: see `penalty_step_limit`.

namespace drape {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;

/// The damping ratio zeta of which half a swing leaves the restitution e of the speed: e = exp(-pi zeta / sqrt(1 -
/// zeta^2)).
Real damping_ratio(Real restitution) {
    if (restitution <= 0) return 1;
    const auto decay = static_cast<Real>(-natural_log(static_cast<double>(restitution)));
    return decay / std::sqrt(pi * pi + decay * decay);
}

/// The damping coefficient of a contact [N s/m].
Real damping_of(const ContactProblem& problem, const RowState& state) {
    const Real ratio = damping_ratio(state.surface.restitution);
    return 2 * ratio * std::sqrt(problem.parameters.stiffness / state.inverse_mass);
}

/// The speed at which both sides still approach each other, after the pushes of earlier contacts.
Real approach_of(const ContactProblem& problem, const ContactRow& row, const RowState& state) {
    return -relative(problem, problem.scratch.velocities, row, state).dot(row.normal);
}

/// Adds to a contact's penalty, and gives the displacements of friction their bound.
/// @param push along the normal, together with what was given before no less than zero [N s]
void add_push(const ContactProblem& problem, ContactRow& row, const RowState& state, Real push) {
    row.impulse.normal += push;
    row.displacement.normal = problem.parameters.displacement_factor * problem.h * row.impulse.normal;
    apply_impulse(problem, problem.scratch.velocities, row, state, push * row.normal);
}

/// Where a force displaces by all of its velocity, particles have moved within the substep by the velocity at its end,
/// and dampers see that. Contacts get their pushes one after the other: dampers that all saw the same approach would
/// together take more than all of it.
void push_by_velocities(ContactProblem& problem) {
    for_each_chosen(problem, [&](ContactRow& row, const RowState& state) {
        const Real force =
            problem.parameters.stiffness * row.depth + damping_of(problem, state) * approach_of(problem, row, state);
        add_push(problem, row, state, problem.h * std::max(force, Real(0)));
    });
}

/// Where a force displaces by half of its velocity, what lies still has the other half at the end of the substep, and
/// dampers that saw it would not let it lie. They see by how much both sides have come nearer within the substep, and
/// what earlier dampers have changed since. As that was half a substep ago, a damper pushes by the mean of the speed
/// that it sees and the one that it leaves: at most it reverses that speed.
void push_by_displacements(ContactProblem& problem) {
    for_each_chosen(problem, [&](ContactRow& row, const RowState& state) {
        add_push(problem, row, state, problem.h * std::max(problem.parameters.stiffness * row.depth, Real(0)));
    });
    for_each_chosen(problem, [&](const ContactRow& row, RowState& state) {
        const Real nearer = -relative(problem, problem.scratch.displacements, row, state).dot(row.normal);
        // Kept against the velocities after the springs, which dampers then change
        state.approach = nearer / problem.h - approach_of(problem, row, state);
    });
    for_each_chosen(problem, [&](ContactRow& row, const RowState& state) {
        const Real approach = state.approach + approach_of(problem, row, state);
        const Real damping = problem.h * damping_of(problem, state);
        const Real push = damping * approach / (1 + damping * state.inverse_mass / 2);
        add_push(problem, row, state, std::max(push, -row.impulse.normal));
    });
}

}  // namespace

Real penalty_step_limit(Real stiffness, Real restitution, Real inverse_mass, Real displacement_factor) {
    const Real zeta = damping_ratio(restitution), frequency = std::sqrt(stiffness * inverse_mass);
    if (displacement_factor == 1) return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / frequency;
    Real w = 2;
    for (int step = 0; step < 8; ++step) w -= (zeta * w * w * w + w * w - 4) / (3 * zeta * w * w + 2 * w);
    return w / frequency;
}

Sweeps respond_by_penalties(ContactProblem& problem) {
    for_each_chosen(problem, [](ContactRow& row, const RowState&) { row.displacement = row.impulse = {}; });
    if (problem.parameters.displacement_factor == 1) {
        push_by_velocities(problem);
    } else {
        push_by_displacements(problem);
    }
    constexpr bool friction_alone = true;
    const Sweeps sweeps = solve(problem, problem.scratch.displacements, friction_alone);
    const Sweeps more = solve(problem, problem.scratch.velocities, friction_alone);
    return sweeps + Sweeps{more.count, more.residual * problem.h};
}

}  // namespace drape
