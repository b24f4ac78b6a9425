#pragma once

#include "drape/model/cloth_model.h"

namespace drape::kernels {

/// As `drape::add_wind_forces`, cell by cell.
void add_wind_forces(const ClothModel& model, const Points& x, const Points& v, Points& f);

}  // namespace drape::kernels
