#include "compact_solve.h"
#include "tuning.h"

// Positions are projected out of balls and ground @cite provot1995, each contact by the least displacement of its
// particles, and held against sliding by friction; then the velocities of those that were pushed are stopped, or
// thrown back. What the projection moves does not become velocity.

namespace drape {
namespace {

/// How far the contact must come along its normal within the substep to be out.
template <class AnyContact>
void aim_displacement(const Displacements& motion, std::span<const Ball> balls, AnyContact& contact) {
    contact.displacement.target = relative(motion, contact).dot(contact.normal) + push_of(contact, balls);
}

/// The push that a contact still asks for, as a fraction of its ball's radius. Planes do not turn.
Real length_of_push(const ContactProblem& problem, const Contact& contact) {
    if (is_plane(contact.ball)) return 0;
    return push_of(contact, problem.balls) / problem.balls[static_cast<std::size_t>(contact.ball)].radius;
}
Real length_of_push(const ContactProblem& /*problem*/, const ContactPlane& /*contact*/) { return 0; }

/// Displaces until all contacts are out and hold.
Sweeps project_positions(ContactProblem& problem) {
    Displacements motion = problem.displacements();
    Sweeps all;
    order_rows(problem);
    for (int round = 0; round < max_rounds; ++round) {
        Real longest = 0;
        for_each_contact(
            problem, [&](auto& contact) __attribute__((flatten)) {
                aim_displacement(motion, problem.balls, contact);
                longest = std::max(longest, length_of_push(problem, contact));
                contact.active = contact.inverse_mass > 0;
            });
        const Sweeps sweeps = solve_contacts(problem, motion, displacement_tolerance(problem));
        all = {all.count + sweeps.count, sweeps.residual};
        if (longest <= short_push) break;
        for_each_contact(problem, [&](auto& contact) { find_again(problem, contact); });
        order_rows(problem);
    }
    return all;
}

/// Contacts that carry nothing, and were given nothing, are free to part, and to meet in a later step.
bool is_loaded(const ContactPlane& contact) { return contact.displacement.normal > 0 || contact.impulse.normal > 0; }

}  // namespace

ResponseReport respond_by_projection(ContactProblem& problem) {
    const Sweeps displaced = project_positions(problem);
    Velocities motion = problem.velocities();
    choose(problem, is_loaded);
    const Sweeps stopped = solve_contacts(problem, motion, velocity_tolerance(problem));
    return {.residual = displaced.residual, .sweeps = displaced.count + stopped.count};
}

}  // namespace drape
