#pragma once

#include "contact_solver.h"

namespace drape {

/// Velocities and positions together, for impulses that change both. Along the normal they measure velocities. Across
/// it they measure the velocity of an impact, and of a resting contact the displacement within the substep, for that is
/// what creeps.
struct Impacts {
    Displacements displacements;
    Velocities velocities;
    Real h;        ///< the substep [s]
    Real resting;  ///< slower approaches are no impacts [m/s]

    static ContactPush& given(ContactPlane& contact) { return contact.impulse; }
};

template <class AnyContact>
Vec3 relative(const Impacts& motion, const AnyContact& contact) {
    const Vec3 velocity = relative(motion.velocities, contact);
    if (contact.approach > motion.resting) return velocity;
    const Vec3 mean = relative(motion.displacements, contact) / contact.remaining;
    return mean + (velocity - mean).dot(contact.normal) * contact.normal;
}

template <class AnyContact>
void push_apart(Impacts& motion, const AnyContact& contact, const Vec3& push) {
    push_apart(motion.velocities, contact, push);
    push_apart(motion.displacements, contact, contact.remaining * push);
}

/// Gives impulses to the contacts that take part.
Sweeps solve_impulses(ContactProblem& problem, bool (*takes_part)(const ContactProblem&, const ContactPlane&));

}  // namespace drape
