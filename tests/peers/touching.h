#pragma once

#include <span>
#include <vector>

#include "drape/model/ball.h"
#include "drape/model/grid.h"

namespace drape::peers {

/// Keeps those of the triangles whose distance to the ball's centre is at most its radius.
/// @par Cost O(triangles); most are decided by a corner within reach, as in `find_touched_triangles`
void keep_touched(const Grid& grid, const Points& x, const Ball& ball, std::vector<int>& triangles);

/// How many triangles are in one set only, all of them within rounding of touching.
/// @param expected, found each in ascending order
/// @throws RunError that names a triangle which is further from the ball's surface than the rounding
int count_ties(const Grid& grid, const Points& x, const Ball& ball, std::span<const int> expected,
               std::span<const int> found);

}  // namespace drape::peers
