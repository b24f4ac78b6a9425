#pragma once

#include <algorithm>

#include "drape/contact/response.h"
#include "tuning.h"

namespace drape {

/// Of the heavier body that can move.
inline Real min_inverse_mass(const ContactPlane& contact) {
    Real first = 0;
    for (const ContactParticle& p : contact.pushed()) first += p.weight * p.share;
    const Real second = contact.inverse_mass - first;
    return first > 0 && second > 0 ? std::min(first, second) : contact.inverse_mass;
}

/// Whether a contact pushes no harder than what rests does. Cloth that carries a ball is pushed by many times its own
/// weight, but so it is by an impact: the ball's weight counts where the contact was there in the substep before.
/// @param impulse along its normal [kg m/s]
/// @param h its substep [s]
/// @param gravity [m/s^2]
inline bool may_rest(const ContactPlane& contact, Real impulse, Real h, Real gravity) {
    const Real in_a_step = h * gravity;
    if (impulse * contact.inverse_mass <= rest_steps * in_a_step) return true;
    return contact.lasts && impulse * min_inverse_mass(contact) <= resting_weights * in_a_step;
}

}  // namespace drape
