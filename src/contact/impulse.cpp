#include "impulse.h"

// An impulse changes velocities at the time of impact, and positions by what is left of the substep then: all that
// happens within the substep is the work of one impulse a contact @cite mirtich1995.

namespace drape {
namespace {

/// Depth that is there without an approach, from a start within a ball say, is pushed out no faster than this [m/s].
constexpr Real push_out_speed = 1;

template <class AnyContact>
void aim_impulse(const ContactProblem& problem, AnyContact& contact) {
    const Real depth = push_of(contact, problem.balls);
    const bool impact = contact.approach > problem.resting;
    const Real of_rest = problem.share * problem.h;
    contact.remaining = impact ? std::min(problem.h, std::max(depth, Real(0)) / contact.approach) : of_rest;
    const Real out = std::min(depth / of_rest - contact.approach, push_out_speed);
    contact.impulse.target = impact ? contact.impulse.target : out;
}

}  // namespace

Sweeps solve_impulses(ContactProblem& problem, bool (*takes_part)(const ContactProblem&, const ContactPlane&)) {
    Impacts motion{problem.displacements(), problem.velocities(), problem.h, problem.resting};
    for_each_contact(problem, [&](auto& contact) { aim_impulse(problem, contact); });
    choose(problem, [&](const ContactPlane& contact) { return takes_part(problem, contact); });
    return sweep_until(problem, velocity_tolerance(problem),
                       [&](auto& contact) { return solve_contact(motion, contact); });
}

ResponseReport respond_by_impulses(ContactProblem& problem) {
    const Sweeps sweeps = solve_impulses(problem, [](const ContactProblem&, const ContactPlane&) { return true; });
    for_each_contact(problem, [&](ContactPlane& contact) {
        const bool rests = contact.approach <= problem.resting;
        contact.displacement.normal = rests ? contact.remaining * contact.impulse.normal : Real(0);
        contact.displacement.friction = rests ? Vec3(contact.remaining * contact.impulse.friction) : Vec3(Vec3::Zero());
    });
    return {.residual = sweeps.residual * problem.h, .sweeps = sweeps.count};
}

}  // namespace drape
