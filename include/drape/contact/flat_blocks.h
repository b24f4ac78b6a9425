#pragma once

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <span>
#include <vector>

#include "drape/base/kernels.h"
#include "drape/base/real.h"
#include "drape/bounds/fold_test.h"
#include "drape/model/grid.h"

namespace drape {

/// Tells which blocks of 2 x 2 cells are so flat that what shares no particle in them cannot come near: touching cells
/// are always near each other, and nearly all of them are in such a block. The proof is that of `FoldTest`, with
/// another bound that costs less. With F0 the derivative in the middle of a block, P the projection onto its plane, and
/// v a vector at rest, |F v| >= |P F v| >= (s - d) |v|, where s is the smaller singular value of F0 and d the largest
/// |P (F - F0)| of the block's triangles.
class FlatBlocks {
public:
    FlatBlocks() = default;
    FlatBlocks(const Grid& grid, Real hx, Real hy);

    /// Follows the cloth to its present positions.
    /// @param x n x 3 [m]
    /// @param reaches of each particle, towards others in its block [m]
    /// @par Cost O(cells)
    void build(const Points& x, std::span<const Real> reaches, Kernels kernels);

    /// Whether all that shares no particle in two cells is farther apart than it reaches; false for cells that do not
    /// touch, and where that is not known.
    [[nodiscard]] bool keep_apart(int i, int j, int other_i, int other_j) const {
        if (room_.empty() || std::abs(i - other_i) > 1 || std::abs(j - other_j) > 1) return false;
        const int column = std::min({i, other_i, grid_.nx - 3}), row = std::min({j, other_j, grid_.ny - 3});
        return room_[static_cast<std::size_t>(row * (grid_.nx - 2) + column)] > 0;
    }

private:
    Grid grid_;
    Real hx_ = 0, hy_ = 0;
    std::vector<Real> room_;  ///< of each block: beyond what two particles in it reach [m]
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
