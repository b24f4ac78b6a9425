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

/// The impulse of one contact's spring and damper in the substep.
template <class AnyContact>
Real penalty_of(const ContactProblem& problem, const AnyContact& contact, Real approach) {
    const Real stiffness = problem.parameters.stiffness;
    const Real damping =
        2 * damping_ratio(restitution_of(problem.parameters, contact)) * std::sqrt(stiffness / contact.inverse_mass);
    return problem.h * std::max(stiffness * contact.depth + damping * approach, Real(0));
}

/// The speed at which they still approach each other, after the pushes of earlier contacts.
template <class AnyContact>
Real approach_of(const Velocities& velocities, const AnyContact& contact) {
    return -relative(velocities, contact).dot(contact.normal);
}

/// Gives a contact its penalty, and the displacements of friction their bound. Contacts get theirs one after the other:
/// dampers that all saw the same approach would together take more than all of it.
template <class AnyContact>
void push_by_penalty(ContactProblem& problem, AnyContact& contact) {
    Velocities velocities = problem.velocities();
    contact.displacement = contact.impulse = {};
    contact.impulse.normal = penalty_of(problem, contact, approach_of(velocities, contact));
    contact.displacement.normal = problem.share * problem.h * contact.impulse.normal;
    push_apart(velocities, contact, contact.impulse.normal * contact.normal);
}

}  // namespace

Real penalty_step_limit(Real stiffness, Real restitution, Real inverse_mass) {
    const Real zeta = damping_ratio(restitution);
    return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / std::sqrt(stiffness * inverse_mass);
}

Sweeps solve_penalties(ContactProblem& problem, TakesPart takes_part) {
    choose(problem, [&](const ContactPlane& contact) { return takes_part(problem, contact); });
    for_each_contact(problem, [&](auto& contact) {
        if (contact.takes_part) push_by_penalty(problem, contact);
    });
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
