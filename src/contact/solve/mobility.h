#pragma once

#include <algorithm>

#include "contact/tuning.h"
#include "drape/contact/response.h"

namespace drape {

/// How an impulse at a contact point moves its particles.
struct Mobility {
    std::array<Real, 4> of_particles{};  ///< how far each, or how much faster: weight times inverse mass [1/kg]
    Real inverse_mass = 0;               ///< that the impulse meets: 1/m = sum w_k^2 / m_k [1/kg]
};

/// Not at all if nothing can move, or where the point hangs on pinned corners so nearly that an impulse, which a ball's
/// mass alone would size, would throw the free one far.
inline Mobility mobility_of(std::span<const ClothInContact> cloths, const ContactRow& row) {
    Mobility found;
    Real largest = 0;
    for (std::size_t k = 0; k < row.count; ++k) {
        const auto& [cloth, particle, weight] = row.particles[k];
        if (weight == 0) continue;
        const Real mobility = weight * cloths[static_cast<std::size_t>(cloth)].inverse_mass(particle);
        found.of_particles[k] = mobility;
        found.inverse_mass += weight * mobility;
        largest = std::max(largest, mobility / weight);
    }
    return found.inverse_mass > 0 && found.inverse_mass >= min_mobility * largest ? found : Mobility{};
}

}  // namespace drape
