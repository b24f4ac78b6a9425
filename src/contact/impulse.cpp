#include "impulse.h"

#include <algorithm>
#include <cmath>

// One impulse per impact changes velocities at its time, and moves positions by that change over the rest of the
// substep @cite mirtich1995. What is still inside after that, and what rests, is projected: impulses that put back what
// has entered would make resting cloth quiver.

namespace drape {
namespace {

bool falls(const ContactProblem& problem, int ball) {
    return !is_plane(ball) && problem.balls[static_cast<std::size_t>(ball)].inverse_mass > 0;
}
bool first_falls(const ContactProblem& /*problem*/, const Contact& /*contact*/) { return true; }
bool first_falls(const ContactProblem& problem, const BallContact& contact) { return falls(problem, contact.first); }

/// How fast gravity makes the approach of two bodies grow [m/s^2]: not at all where both fall, or where it draws them
/// apart. Cloth counts as falling where it may fall onto what it meets: what its springs add within a substep is not
/// known, but cloth beside or below a ball hangs in them.
template <class AnyContact>
Real growth_of_approach(const ContactProblem& problem, const AnyContact& contact) {
    const Real downwards = -problem.cloths.front().model.gravity.dot(contact.normal);
    return std::max(downwards * Real(first_falls(problem, contact) - falls(problem, contact.ball)), Real(0));
}
Real growth_of_approach(const ContactProblem& /*problem*/, const PairContact& /*contact*/) { return 0; }

/// Sets how much of the substep is left after the impact, and the velocity at which the bodies part at the end of the
/// substep. Depth and approach are those of the end: gravity has made the approach grow since the impact, and slows the
/// rebound by the same amount. What would land again within the substep stops instead.
template <class AnyContact>
void time_impact(const ContactProblem& problem, AnyContact& contact) {
    const Real depth = std::max(push_of(contact, problem.balls), Real(0));
    const Real growth = growth_of_approach(problem, contact), at_end = contact.approach;
    const Real at_impact = std::sqrt(std::max(at_end * at_end - 2 * growth * depth, Real(0)));
    const Real remaining = std::min(problem.h, 2 * depth / (at_end + at_impact)), grown = growth * remaining;
    const Real parting = restitution_of(problem.parameters, contact) * (at_end - grown) - grown;
    const bool parts = parting > 0;
    contact.impulse.target = parts ? parting : Real(0);
    contact.remaining = parts ? remaining : std::min(problem.h, depth / at_end);
}

}  // namespace

Sweeps solve_impacts(ContactProblem& problem) {
    bool any = false;
    for_each_contact(problem, [&](auto& contact) {
        contact.active = contact.depth > 0 && is_impact(problem, contact) && contact.inverse_mass > 0;
        if (!contact.active) return;
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
