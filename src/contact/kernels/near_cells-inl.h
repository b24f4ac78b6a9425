#include "near_cells.h"

#include <array>
#include <bit>
#include <limits>

#include "bounds/kernels/patch_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// Cells in rows of the same columns, one below the other: few enough for a row of particles to be a word of bits.
struct Block {
    static constexpr int max_columns = 31, max_rows = 16;

    int cell;     ///< the first
    Patch patch;  ///< the particles at the corners
};

/// The particles of each row that pass a test, a bit each.
using RowBits = std::array<std::uint32_t, Block::max_rows + 1>;

template <class V>
HWY_INLINE V square_between(const Lanes3<V>& a, const Lanes3<V>& b) {
    const Lanes3<V> offset = minus(a, b);
    return dot(offset, offset);
}

/// The square of the longest side of the cells, diagonals not counted; sides without a length are left out.
HWY_INLINE Real longest_side_square(const Patch& patch) {
    Real square = 0;
    with_vectors_for(patch.columns - 1, [&](auto d) HWY_ATTR {
        const int lanes = static_cast<int>(hn::Lanes(d)), cells = patch.columns - 1;
        const auto particles = [&](int p) HWY_ATTR {
            return Lanes3<hn::Vec<decltype(d)>>{hn::LoadU(d, patch.x + p), hn::LoadU(d, patch.y + p),
                                                hn::LoadU(d, patch.z + p)};
        };
        auto longest = hn::Zero(d);
        // Where the first of two is not a number, x86 takes the second; elsewhere all stay open
        const auto see = [&](const auto& from, const auto& to)
                             HWY_ATTR { longest = hn::Max(square_between(from, to), longest); };
        for (int i = 0;; i += lanes) {
            i = HWY_MIN(i, cells - lanes);
            auto above = particles(i), above_next = particles(i + 1);
            see(above, above_next);
            for (int j = 1; j < patch.rows; ++j) {
                const int at = j * patch.stride + i;
                const auto here = particles(at), next = particles(at + 1);
                see(above, here);
                see(above_next, next);
                see(here, next);
                above = here, above_next = next;
            }
            if (i + lanes >= cells) break;
        }
        square = largest_lane(d, longest);
    });
    return square;
}

/// What the particles of a block say about its triangles and a ball. Each row of particles is between two of cells.
class BlockTest {
public:
    BlockTest(const Block& block, const Vec3& p, Real radius) : block_(block), square_(radius * radius) {
        with_vectors_for(block.patch.columns, [&](auto d) HWY_ATTR {
            const auto limit = hn::Set(d, square_);
            for_each_vector(d, block.patch, [&](int i, int j) HWY_ATTR {
                const auto square = square_to(d, block.patch, j * block.patch.stride + i, p);
                hn::StoreU(square, d, &squares_[j * row_stride + i]);
                inside_[at(j)] |= lane_bits(d, hn::Le(square, limit)) << i;
            });
        });
    }

    /// Writes the bits of each row.
    /// @param columns of cells in the grid
    /// @param step from the bits of one row to those of the next
    HWY_INLINE void write(int columns, CellBits* bits, int step) {
        const int count = block_.patch.columns - 1, rows = block_.patch.rows - 1;
        const std::uint32_t all = (1u << count) - 1;
        std::uint32_t open_rows = 0;
        for (int j = 0; j < rows; ++j) {
            open_rows |= static_cast<std::uint32_t>((first_of(j) & second_of(j) & all) != all) << j;
        }
        if (open_rows != 0) find_far(std::countr_zero(open_rows), std::bit_width(open_rows) + 1);
        for (int j = 0; j < rows; ++j) {
            const std::uint32_t first = first_of(j) & all, second = second_of(j) & all;
            // Of rows that are not open no particle counts as far, but all their triangles have a corner inside
            const std::uint32_t above = far_[at(j)], below = far_[at(j + 1)], diagonal = above >> 1 & below;
            bits[j * step] = {block_.cell + j * columns, first, second, all & ~(first | (above & diagonal)),
                              all & ~(second | (below >> 1 & diagonal))};
        }
    }

private:
    static constexpr int row_stride = Block::max_columns + 1;
    static std::size_t at(int row) { return static_cast<std::size_t>(row); }

    /// The triangles a, c, b of a row of cells with a corner in the ball, and b, c, d.
    HWY_INLINE std::uint32_t first_of(int j) const { return inside_[at(j)] | inside_[at(j)] >> 1 | inside_[at(j + 1)]; }
    HWY_INLINE std::uint32_t second_of(int j) const {
        return inside_[at(j)] >> 1 | inside_[at(j + 1)] | inside_[at(j + 1)] >> 1;
    }

    /// Which particles of some rows are so far from the ball that no triangle with such corners alone touches it.
    HWY_INLINE void find_far(int begin, int end) {
        constexpr Real rounding = 32 * std::numeric_limits<Real>::epsilon();
        const Patch& all = block_.patch;
        const int skipped = begin * all.stride;
        const Patch some{all.x + skipped, all.y + skipped, all.z + skipped, all.columns, end - begin, all.stride};
        const Real beyond = square_ + (1 + rounding) * longest_side_square(some);
        with_vectors_for(all.columns, [&](auto d) HWY_ATTR {
            const auto limit = hn::Set(d, beyond), shrink = hn::Set(d, 1 - rounding);
            for_each_vector(d, some, [&](int i, int j) HWY_ATTR {
                const auto square = hn::LoadU(d, &squares_[(begin + j) * row_stride + i]);
                far_[at(begin + j)] |= lane_bits(d, hn::Gt(hn::Mul(square, shrink), limit)) << i;
            });
        });
    }

    const Block& block_;
    Real square_;
    HWY_ALIGN Real squares_[row_stride * (Block::max_rows + 1)];  ///< of the distances, row by row
    RowBits inside_{}, far_{};
};

/// How many runs, from the first on, are below each other in the same columns: as many as a block has rows at most.
HWY_INLINE int rows_of_block(std::span<const CellRun> cells) {
    const CellRun& first = cells[0];
    const int most = static_cast<int>(HWY_MIN(cells.size(), std::size_t{Block::max_rows}));
    int rows = 1;
    while (rows < most && cells[static_cast<std::size_t>(rows)] == CellRun{first.row + rows, first.column, first.count})
        ++rows;
    return rows;
}

int classify_cells_of(const Grid& grid, const Real* const x[3], const Vec3& p, Real radius,
                      std::span<const CellRun> cells, CellBits* bits) {
    CellBits* next = bits;
    while (!cells.empty()) {
        const CellRun& run = cells[0];
        const int rows = rows_of_block(cells), blocks = (run.count + Block::max_columns - 1) / Block::max_columns;
        for (int k = 0; k < blocks; ++k) {
            const int column = run.column + run.count * k / blocks, end = run.column + run.count * (k + 1) / blocks;
            const int corner = grid.particle(column, run.row);
            const Block block{run.row * grid.cell_columns() + column,
                              {x[0] + corner, x[1] + corner, x[2] + corner, end - column + 1, rows + 1, grid.nx}};
            BlockTest(block, p, radius).write(grid.cell_columns(), next + k, blocks);
        }
        next += rows * blocks;
        cells = cells.subspan(static_cast<std::size_t>(rows));
    }
    return static_cast<int>(next - bits);
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(classify_cells_of);

int classify_cells(const Grid& grid, const Real* const x[3], const Vec3& p, Real radius, std::span<const CellRun> cells,
                   CellBits* bits) {
    return HWY_DYNAMIC_DISPATCH(classify_cells_of)(grid, x, p, radius, cells, bits);
}

}  // namespace drape::kernels
#endif
