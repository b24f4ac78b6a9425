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

/// How fast gravity makes the approach of two bodies grow [m/s^2]: not at all where both fall.
template <class AnyContact>
Real growth_of_approach(const ContactProblem& problem, const AnyContact& contact) {
    const Real downwards = -problem.cloths.front().model.gravity.dot(contact.normal);
    return downwards * Real(first_falls(problem, contact) - falls(problem, contact.ball));
}
Real growth_of_approach(const ContactProblem& /*problem*/, const PairContact& /*contact*/) { return 0; }

/// Sets how much of the substep is left after the impact, and the velocity at which the bodies part at the end of the
/// substep. Depth and approach are those of the end: gravity has made the approach grow since the impact, and by as
/// much slows what bounces. What is deeper than it can have fallen within the substep has come with the approach of its
/// end.
template <class AnyContact>
void time_impact(const ContactProblem& problem, AnyContact& contact) {
    const Real depth = std::max(push_of(contact, problem.balls), Real(0));
    const Real growth = growth_of_approach(problem, contact), at_end = contact.approach;
    const Real square = at_end * at_end - 2 * growth * depth;
    contact.remaining = std::min(problem.h, 2 * depth / (at_end + (square > 0 ? std::sqrt(square) : at_end)));
    const Real grown = growth * contact.remaining;
    contact.impulse.target = std::max(restitution_of(problem.parameters, contact) * (at_end - grown) - grown, Real(0));
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
