#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "drape/bounds/broad_phase.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape::kernels {

inline constexpr int max_near_cells = 31;

/// Which cells of a row may touch a ball, as far as their corners tell: bit k is the k-th cell. For a point of a
/// triangle with weights w_i, |p - sum w_i v_i|^2 = sum w_i |p - v_i|^2 - sum_{i<j} w_i w_j |v_i - v_j|^2 (Leibniz).
/// With sides of s at most, and so a diagonal of 2 s at most between v_2 and v_3, the last sum is at most
/// (w_1 (1 - w_1) + 4 w_2 w_3) s^2 <= s^2: where all corners are farther away than sqrt(r^2 + s^2), nothing touches.
/// @param corners two rows of particles, for no more than `max_near_cells` cells between them
/// @param p, radius of the ball, grown by the cloth's thickness
/// @par Cost O(cells), vectorised
std::uint32_t near_cells(const Patch& corners, const Vec3& p, Real radius);

/// Calls visit(cell) for each of these, of some cells.
/// @param x n x 3 [m]
template <class Visit>
void for_each_near_cell(const Grid& grid, const Points& x, const Vec3& p, Real radius, const CellRange& cells,
                        Visit visit) {
    for (int j = cells.j0; j < cells.j1; ++j) {
        for (int i = cells.i0; i < cells.i1; i += max_near_cells) {
            const CellRange some{i, j, std::min(i + max_near_cells, cells.i1), j + 1};
            std::uint32_t near = near_cells(patch_of(grid, some, x), p, radius);
            for (; near != 0; near &= near - 1) visit(grid.cell(i + std::countr_zero(near), j));
        }
    }
}

}  // namespace drape::kernels
