#pragma once

#include "contact_solver.h"

namespace drape {

/// For impulses that change velocities and positions together.
struct Impacts {
    Displacements displacements;
    Velocities velocities;

    static ContactPush& accumulated(ContactPlane& contact) { return contact.impulse; }
};

template <class AnyContact>
Vec3 relative(const Impacts& motion, const AnyContact& contact) {
    return relative(motion.velocities, contact);
}

template <class AnyContact>
void push_apart(Impacts& motion, const AnyContact& contact, const Vec3& push) {
    push_apart(motion.velocities, contact, push);
    push_apart(motion.displacements, contact, contact.remaining * push);
}

/// Gives impulses to the contacts that are impacts.
Sweeps solve_impacts(ContactProblem& problem);

}  // namespace drape
