#include "impulse.h"

// One impulse per impact changes velocities at its time, and moves positions by that change over the rest of the
// substep @cite mirtich1995. What is still inside after that, and what rests, is projected: impulses that put back what
// has entered would make resting cloth quiver.

namespace drape {
namespace {

/// Sets how much of the substep is left after the impact.
template <class AnyContact>
void time_impact(const ContactProblem& problem, AnyContact& contact) {
    const Real depth = std::max(push_of(contact, problem.balls), Real(0));
    contact.remaining = std::min(problem.h, depth / contact.approach);
}

}  // namespace

Sweeps solve_impacts(ContactProblem& problem) {
    bool any = false;
    for_each_contact(problem, [&](auto& contact) {
        contact.takes_part = is_impact(problem, contact) && contact.inverse_mass > 0;
        if (!contact.takes_part) return;
        time_impact(problem, contact);
        any = true;
    });
    if (!any) return {};
    Impacts motion{problem.displacements(), problem.velocities()};
    return sweep_until(problem, velocity_tolerance(problem),
                       [&](auto& contact) { return solve_contact(motion, contact); });
}

ResponseReport respond_by_impulses(ContactProblem& problem) {
    const Sweeps impacts = solve_impacts(problem);
    if (impacts.count > 0) for_each_contact(problem, [&](auto& contact) { follow(problem, contact); });
    ResponseReport report = respond_by_projection(problem);
    report.residual = std::max(report.residual, impacts.residual * problem.h);
    report.sweeps += impacts.count;
    return report;
}

}  // namespace drape
