#pragma once

#include <span>
#include <vector>

#include "drape/contact/detection.h"

namespace drape::kernels {

/// The triangles that touch a ball; only those that their corners leave open cost a closest point.
/// @param radius of the ball about p, grown by the cloth's thickness
/// @param triangles receives their numbers; what it has had before is room for them
void find_touched(const Grid& grid, const Points& x, const Vec3& p, Real radius, std::span<const CellRun> cells,
                  std::vector<int>& triangles);

}  // namespace drape::kernels
