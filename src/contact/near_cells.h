#pragma once

#include <span>

#include "drape/base/real.h"
#include "drape/model/grid.h"

namespace drape::kernels {

/// Tells for each cell whether its corners leave open that one of its triangles is within `reach` of p. For a point of
/// a triangle with weights w_i, |p - sum w_i v_i|^2 = sum w_i |p - v_i|^2 - sum_{i<j} w_i w_j |v_i - v_j|^2 (Leibniz),
/// which is at least the smallest |p - v_i|^2 less a third of the longest edge squared.
/// @param x n x 3, by coordinate
/// @param near one flag a cell
/// @par Cost O(cells), vectorised over cells that follow one another in a row
void flag_near_cells(const Grid& grid, const Real* const x[3], const Vec3& p, Real reach, std::span<const int> cells,
                     bool* near);

}  // namespace drape::kernels
