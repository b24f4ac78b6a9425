#include "penalty.h"

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
template <class AnyContact>
Real damping_of(const ContactProblem& problem, const AnyContact& contact) {
    const Real ratio = damping_ratio(restitution_of(problem.parameters, contact));
    return 2 * ratio * std::sqrt(problem.parameters.stiffness / contact.inverse_mass);
}

/// The speed at which bodies still approach each other, after the pushes of earlier contacts.
template <class AnyContact>
Real approach_of(const Velocities& velocities, const AnyContact& contact) {
    return -relative(velocities, contact).dot(contact.normal);
}

/// Adds to a contact's penalty, and gives the displacements of friction their bound.
/// @param push along the normal, together with what was given before no less than zero [N s]
template <class AnyContact>
void add_push(const ContactProblem& problem, AnyContact& contact, Real push) {
    Velocities velocities = problem.velocities();
    contact.impulse.normal += push;
    contact.displacement.normal = problem.share * problem.h * contact.impulse.normal;
    push_apart(velocities, contact, push * contact.normal);
}

template <class Visit>
void for_each_chosen(ContactProblem& problem, Visit visit) {
    for_each_contact(problem, [&](auto& contact) {
        if (contact.active) visit(contact);
    });
}

/// Where a force displaces by all of its velocity, particles have moved within the substep by the velocity at its end,
/// and dampers see that. Contacts get their pushes one after the other: dampers that all saw the same approach would
/// together take more than all of it.
void push_by_velocities(ContactProblem& problem) {
    for_each_chosen(problem, [&](auto& contact) {
        const Real force = problem.parameters.stiffness * contact.depth +
                           damping_of(problem, contact) * approach_of(problem.velocities(), contact);
        add_push(problem, contact, problem.h * std::max(force, Real(0)));
    });
}

/// Where a force displaces by half of its velocity, what lies still has the other half at the end of the substep, and
/// dampers that saw it would not let it lie. They see by how much the bodies have come nearer within the substep, and
/// what earlier dampers have changed since. As that was half a substep ago, a damper pushes by the mean of the speed
/// that it sees and the one that it leaves: at most it reverses that speed.
void push_by_displacements(ContactProblem& problem) {
    for_each_chosen(problem, [&](auto& contact) {
        add_push(problem, contact, problem.h * std::max(problem.parameters.stiffness * contact.depth, Real(0)));
    });
    for_each_chosen(problem, [&](auto& contact) {
        const Real nearer = -relative(problem.displacements(), contact).dot(contact.normal);
        // Kept against the velocities after the springs, which dampers then change
        contact.approach = nearer / problem.h - approach_of(problem.velocities(), contact);
    });
    for_each_chosen(problem, [&](auto& contact) {
        const Real approach = contact.approach + approach_of(problem.velocities(), contact);
        const Real damping = problem.h * damping_of(problem, contact);
        const Real push = damping * approach / (1 + damping * contact.inverse_mass / 2);
        add_push(problem, contact, std::max(push, -contact.impulse.normal));
    });
}

}  // namespace

Real penalty_step_limit(Real stiffness, Real restitution, Real inverse_mass, Real share) {
    const Real zeta = damping_ratio(restitution), frequency = std::sqrt(stiffness * inverse_mass);
    if (share == 1) return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / frequency;
    Real w = 2;
    for (int step = 0; step < 8; ++step) w -= (zeta * w * w * w + w * w - 4) / (3 * zeta * w * w + 2 * w);
    return w / frequency;
}

Sweeps solve_penalties(ContactProblem& problem, IsActive active) {
    choose(problem, [&](const ContactPlane& contact) { return contact.depth > 0 && active(problem, contact); });
    for_each_chosen(problem, [](ContactPlane& contact) { contact.displacement = contact.impulse = {}; });
    if (problem.share == 1) {
        push_by_velocities(problem);
    } else {
        push_by_displacements(problem);
    }
    Displacements displacements = problem.displacements();
    const Sweeps sweeps = sweep_until(problem, displacement_tolerance(problem),
                                      [&](auto& contact) { return solve_friction(displacements, contact); });
    Velocities velocities = problem.velocities();
    const Sweeps more = sweep_until(problem, velocity_tolerance(problem),
                                    [&](auto& contact) { return solve_friction(velocities, contact); });
    return {sweeps.count + more.count, std::max(sweeps.residual, more.residual * problem.h)};
}

ResponseReport respond_by_penalties(ContactProblem& problem) {
    const Sweeps sweeps = solve_penalties(problem, [](const ContactProblem&, const ContactPlane&) { return true; });
    return {.residual = sweeps.residual, .sweeps = sweeps.count};
}

}  // namespace drape
