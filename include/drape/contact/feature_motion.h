#pragma once

#include <array>

#include "drape/base/real.h"

namespace drape {

/// Two features as they move through a substep, on which each particle moves straight and evenly.
struct FeatureMotion {
    int first_count = 1;                 ///< particles of the first feature: 1 against a triangle, or 2 for two edges
    std::array<Vec3, 4> start{};         ///< the particles of the first feature, then those of the second [m]
    std::array<Vec3, 4> displacement{};  ///< [m]

    /// How far the features are apart after a part of the displacement [m].
    [[nodiscard]] Real distance_after(Real part) const;

    /// No two of their points come nearer to each other, nor farther from each other, than by this in all [m].
    [[nodiscard]] Real max_approach() const;
};

/// Which part of their displacement two features may go and still stay apart: 1 if they come nowhere nearer to each
/// other than a tenth of their distance, or else a part after which at least that is left. Nor do they come nearer than
/// the least distance that cloth is to keep, or nearer at all if they are already: else a load that lasts would press
/// them together substep by substep, down to rounding. By conservative advancement: what is left of the distance,
/// divided by the longest approach, is a part of the displacement on which they cannot meet.
/// @param distance at the start, above zero [m]
/// @param least that cloth is to keep [m]
/// @par Cost a distance a round; what is not about to meet needs none or one
Real safe_part_of(const FeatureMotion& motion, Real distance, Real least);

}  // namespace drape
