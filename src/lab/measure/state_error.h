#pragma once

#include <string_view>

#include "disturbed_start.h"
#include "drape/base/enum_names.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// What of two states of a cloth is compared.
enum class Measure {
    Position,  ///< root mean square distance of particles, over the cloth's side
    Overall    ///< the largest difference of sag, centre of mass (both over the side) and energy (over M g side)
};

template <>
inline constexpr auto enum_names<Measure> = all_names<Measure>("position", "overall");

/// Positions, where small errors stay small; beyond `most_growth`, or where the growth is no number, only what does not
/// depend on the single particle.
/// @param growth of a small error on the way to the horizon
Measure measure_for(double growth);

double position_error(const Points& x, const Points& exact, Real side);

double overall_error(const ClothModel& model, const ClothState& state, const ClothState& exact, Real side);

double error_of(Measure measure, const ClothModel& model, const ClothState& state, const ClothState& exact, Real side);

}  // namespace drape
