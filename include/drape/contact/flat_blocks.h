#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "drape/base/kernels.h"
#include "drape/base/real.h"
#include "drape/bounds/fold_test.h"
#include "drape/model/grid.h"

namespace drape {

/// Tells in which blocks of 2 x 2 cells features may come near each other that share no particle. Touching cells are
/// always near each other, but nearly all of them are in a block that is so flat that nothing in it can meet. The proof
/// is that of `FoldTest`, with another bound that costs less. With F0 the derivative in the middle of a block, P the
/// projection onto its plane, and v a vector at rest, |F v| >= |P F v| >= (s - d) |v|, where s is the smaller singular
/// value of F0 and d the largest |P (F - F0)| of the block's triangles. Until it is built, no block is flat.
class FlatBlocks {
public:
    FlatBlocks() = default;
    FlatBlocks(const Grid& grid, Real hx, Real hy);

    /// Follows the cloth to its present positions.
    /// @param x n x 3 [m]
    /// @param reaches of each particle, towards others in its block [m]
    /// @par Cost O(cells)
    void build(const Points& x, std::span<const Real> reaches, Kernels kernels);

    /// The blocks in which something may be within reach.
    [[nodiscard]] std::span<const int> uneven() const { return uneven_; }

    /// Calls visit(one, two) with the numbers of every two touching cells of a block, and of each cell with itself;
    /// over all blocks, once for each such pair.
    template <class Visit>
    void for_each_pair_of_cells(int block, Visit visit) const {
        const int cell_columns = grid_.cell_columns(), row = block / columns(), column = block % columns();
        const int end_row = std::min(row + 2, grid_.cell_rows()), end_column = std::min(column + 2, cell_columns);
        // Two cells may be in several blocks, and are this one's if they begin where it does, or it is the last
        const auto is_own = [](int first, int second, int begin, int last) {
            return std::min({first, second, last}) == begin;
        };
        for (int j = row; j < end_row; ++j) {
            for (int i = column; i < end_column; ++i) {
                for (int k = j; k < end_row; ++k) {
                    for (int m = k == j ? i : column; m < end_column; ++m) {
                        if (!is_own(i, m, column, columns() - 1) || !is_own(j, k, row, rows() - 1)) continue;
                        visit(j * cell_columns + i, k * cell_columns + m);
                    }
                }
            }
        }
    }

private:
    /// Of the blocks; a strip that is one cell wide has blocks which are one cell wide.
    [[nodiscard]] int columns() const { return std::max(grid_.nx - 2, 1); }
    [[nodiscard]] int rows() const { return std::max(grid_.ny - 2, 1); }

    Grid grid_;
    Real hx_ = 0, hy_ = 0;
    std::vector<Real> room_;   ///< of each block: beyond what two particles in it reach [m]
    std::vector<int> uneven_;  ///< their numbers, row * columns() + column
};

/// More than the bound on a block's derivatives loses by rounding, for derivatives of length 1.
constexpr Real block_rounding = 1024 * std::numeric_limits<Real>::epsilon();

/// What the room of blocks is made from: see `FlatBlocks`.
struct BlockRoom {
    const Grid& grid;
    const Points& x;                ///< n x 3 [m]
    std::span<const Real> reaches;  ///< of each particle [m]
    Real hx, hy;                    ///< at rest [m]
};

/// Sets the room of each block. @pre at least 2 x 2 cells
void find_block_room(const BlockRoom& of, std::span<Real> room, Kernels kernels);

}  // namespace drape
