#pragma once

#include <algorithm>

#include "contact/tuning.h"
#include "drape/contact/response.h"

namespace drape {

/// What an impulse at the contact point meets: 1/m = sum w_k^2 / m_k over its particles. Zero if nothing can move, and
/// where the point hangs on pinned corners so nearly that an impulse would throw the free one far.
/// @param mobilities weight times inverse mass, of each particle [1/kg]
inline Real inverse_mass_of_particles(const ContactRow& row, const std::array<Real, 4>& mobilities) {
    Real sum = 0, largest = 0;
    for (std::size_t k = 0; k < row.count; ++k) {
        const Real weight = row.particles[k].weight;
        if (weight == 0) continue;
        sum += weight * mobilities[k];
        largest = std::max(largest, mobilities[k] / weight);
    }
    return sum < min_mobility * largest ? Real(0) : sum;
}

/// How far an impulse moves each particle, or speeds it up: not at all where the point hangs on pinned corners. Else a
/// ball's mass alone would size the impulse, and throw the free corner far.
inline std::array<Real, 4> mobilities_of(std::span<const ClothInContact> cloths, const ContactRow& row) {
    std::array<Real, 4> mobilities{};
    for (std::size_t k = 0; k < row.count; ++k) {
        const auto& [cloth, particle, weight] = row.particles[k];
        mobilities[k] = weight * cloths[static_cast<std::size_t>(cloth)].inverse_mass(particle);
    }
    return inverse_mass_of_particles(row, mobilities) > 0 ? mobilities : std::array<Real, 4>{};
}

}  // namespace drape
