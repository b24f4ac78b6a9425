#pragma once

#include <cstdint>
#include <span>

#include "drape/bounds/broad_phase.h"

namespace drape::kernels {

/// What their corners say about the triangles of cells that follow one another, and a point: a bit a cell.
struct Verdicts {
    int cell;              ///< of bit 0
    int count;             ///< of cells
    std::uint32_t first;   ///< triangle 2 cell has a corner within reach
    std::uint32_t second;  ///< triangle 2 cell + 1 has one
    std::uint32_t open;    ///< a triangle without such a corner may be within reach all the same
};

/// Judges cells by their corners. For a point of a triangle with weights w_i,
/// |p - sum w_i v_i|^2 = sum w_i |p - v_i|^2 - sum_{i<j} w_i w_j |v_i - v_j|^2 (Leibniz), which is at least the
/// smallest |p - v_i|^2 less a third of the longest edge squared: beyond that nothing is open.
/// @param x n x 3, by coordinate
/// @param verdicts receives those with a bit set; room for one a cell
/// @return how many these are
/// @par Cost O(cells), vectorised
int judge_cells(const Grid& grid, const Real* const x[3], const Vec3& p, Real reach, std::span<const CellRun> cells,
                Verdicts* verdicts);

}  // namespace drape::kernels
