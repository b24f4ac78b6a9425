#pragma once

#include "drape/model/cloth_model.h"

namespace drape::kernels {

/// Adds the force of the moving air on every triangle: the pressure of a flat plate, along its normal,
/// 1/2 C rho |u.n| (u.n) A with u the air's velocity relative to the triangle's mean, a third to each corner.
/// @param x, v, f n x 3 each, by coordinate
void wind_forces(const ClothModel& model, const Real* const x[3], const Real* const v[3], Real* const f[3]);

}  // namespace drape::kernels
