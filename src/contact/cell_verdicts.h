#pragma once

#include <cstdint>
#include <span>

#include "drape/base/real.h"
#include "drape/model/grid.h"

namespace drape::kernels {

/// What the corners of a cell say about its two triangles and a point: flags of a byte.
struct Verdict {
    static constexpr std::uint8_t first = 1;   ///< triangle 2 cell has a corner within reach
    static constexpr std::uint8_t second = 2;  ///< triangle 2 cell + 1 has one
    static constexpr std::uint8_t open = 4;    ///< a triangle without such a corner may be within reach all the same
    static constexpr std::uint8_t both = first | second;
};

/// Judges cells by their corners. For a point of a triangle with weights w_i,
/// |p - sum w_i v_i|^2 = sum w_i |p - v_i|^2 - sum_{i<j} w_i w_j |v_i - v_j|^2 (Leibniz), which is at least the
/// smallest |p - v_i|^2 less a third of the longest edge squared: beyond that nothing is open.
/// @param x n x 3, by coordinate
/// @param cells in any order; those that follow one another in a row of the grid are judged together
/// @param verdicts one a cell
/// @par Cost O(cells), vectorised
void judge_cells(const Grid& grid, const Real* const x[3], const Vec3& p, Real reach, std::span<const int> cells,
                 std::uint8_t* verdicts);

}  // namespace drape::kernels
