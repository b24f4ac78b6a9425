#pragma once

#include "drape/model/cloth_model.h"

namespace drape {

/// Mechanical energy of a cloth [J].
struct Energy {
    Real kinetic = 0;
    Real gravity = 0;  ///< relative to y = 0
    Real spring = 0;
    [[nodiscard]] Real total() const { return kinetic + gravity + spring; }
};

/// @par Cost O(n), as a force evaluation; sums run row by row in a fixed order
Energy compute_energy(const ClothModel& model, const ClothState& state);

/// The largest relative elongation |d|/L0 - 1 over the structural springs.
Real largest_stretch(const ClothModel& model, const Points& x);

}  // namespace drape
