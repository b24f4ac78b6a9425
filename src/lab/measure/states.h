#pragma once

#include "drape/base/enum_names.h"
#include "drape/base/real.h"
#include "drape/model/cloth_model.h"
#include "drape/model/grid.h"

namespace drape {

/// An error at the start of a motion, as root mean square over the free particles [m]: small against any motion, large
/// against rounding.
constexpr Real small_error = sizeof(Real) == sizeof(double) ? Real(1e-9) : Real(1e-4);

/// An error that grows more than this on the way to a horizon makes positions there a matter of luck.
constexpr double most_growth = 50;

/// A state with that error in every free coordinate, the same each time: symmetry would hide what grows.
ClothState disturbed(const ClothModel& model, ClothState state);

/// What of two states of a cloth is compared.
enum class Measure {
    Position,  ///< root mean square distance of particles, over the cloth's side
    Overall    ///< the largest difference of sag, centre of mass (both over the side) and energy (over M g side)
};

/// Positions, where small errors stay small; beyond `most_growth`, or where the growth is no number, only what does not
/// depend on the single particle.
/// @param growth of a small error on the way to the horizon
Measure measure_for(double growth);

double position_error(const Points& x, const Points& exact, Real side);

double overall_error(const ClothModel& model, const ClothState& state, const ClothState& exact, Real side);

double error_of(Measure measure, const ClothModel& model, const ClothState& state, const ClothState& exact, Real side);

}  // namespace drape
