#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drape/contact/contact.h"

namespace drape::kernels {

/// The triangles that touch a ball; only those that their corners leave open cost a closest point.
/// @param radius of the ball about p, grown by the cloth's thickness
/// @param triangles receives their numbers; what it has had before is room for them
void find_touched(const Grid& grid, const Points& x, const Vec3& p, Real radius, std::span<const CellRun> cells,
                  std::vector<int>& triangles);

/// As `drape::find_contacts`: closest points of the near triangles by batches, and contacts for those alone that touch.
std::int64_t find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                           std::span<const CellRun> cells, std::vector<Contact>& contacts);

}  // namespace drape::kernels
