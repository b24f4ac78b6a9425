#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "drape/base/assert.h"
#include "drape/bounds/broad_phase.h"

namespace drape::kernels {

/// What their corners say about the triangles of cells that follow one another, and a ball: a bit a cell.
struct CellBits {
    int cell;                   ///< of bit 0; there are 31 at most
    std::uint32_t first;        ///< triangle 2 cell has a corner in the ball
    std::uint32_t second;       ///< triangle 2 cell + 1 has one
    std::uint32_t first_open;   ///< triangle 2 cell has none, and may touch the ball all the same
    std::uint32_t second_open;  ///< the same of triangle 2 cell + 1

    [[nodiscard]] std::uint32_t near() const { return first | second | first_open | second_open; }
};

/// Classifies cells by their corners. For a point of a triangle with weights w_i,
/// |p - sum w_i v_i|^2 = sum w_i |p - v_i|^2 - sum_{i<j} w_i w_j |v_i - v_j|^2 (Leibniz). With sides of s at most, and
/// so a diagonal of 2 s at most between v_2 and v_3, the last sum is at most (w_1 (1 - w_1) + 4 w_2 w_3) s^2 <= s^2:
/// where all corners are farther away than sqrt(r^2 + s^2), the triangle is not open.
/// @param x n x 3, by coordinate
/// @param p, radius of the ball, grown by the cloth's thickness
/// @param bits receives those of all cells, in their order, also where none is set; room for one a cell
/// @return how many these are
/// @par Cost O(cells), vectorised; rows of cells below each other share what is found of the particles between them
int classify_cells(const Grid& grid, const Real* const x[3], const Vec3& p, Real radius, std::span<const CellRun> cells,
                   CellBits* bits);

/// Calls visit(cell) for each cell of which a bit is set.
template <class Visit>
void for_each_set(const CellBits& bits, std::uint32_t set, Visit visit) {
    for (; set != 0; set &= set - 1) visit(bits.cell + std::countr_zero(set));
}

/// Calls visit(some) for the bits of some thousand cells at a time.
template <class Visit>
void visit_near(const Grid& grid, const Points& x, const Vec3& p, Real radius, std::span<const CellRun> cells,
                Visit visit) {
    const Real* const xs[3] = {x.col(0).data(), x.col(1).data(), x.col(2).data()};
    std::array<CellBits, 4096> bits;  // a run of a grid is no longer
    for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
        for (std::size_t room = bits.size(); end < cells.size(); ++end) {
            const auto count = static_cast<std::size_t>(cells[end].count);
            if (count > room) break;
            room -= count;
        }
        DRAPE_ASSERT(end > begin);
        const int found = classify_cells(grid, xs, p, radius, cells.subspan(begin, end - begin), bits.data());
        visit(std::span(bits).first(static_cast<std::size_t>(found)));
    }
}

}  // namespace drape::kernels
