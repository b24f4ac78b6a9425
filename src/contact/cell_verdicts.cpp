#include "cell_verdicts.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/cell_verdicts.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One coordinate after the other of neighbouring particles.
template <class V>
struct Corners {
    V x, y, z;
};

template <class D>
HWY_INLINE Corners<hn::Vec<D>> corners_at(D d, const Real* const x[3], int at) {
    return {hn::LoadU(d, x[0] + at), hn::LoadU(d, x[1] + at), hn::LoadU(d, x[2] + at)};
}

template <class V>
HWY_INLINE V square_between(const Corners<V>& a, const Corners<V>& b) {
    const V dx = hn::Sub(a.x, b.x), dy = hn::Sub(a.y, b.y), dz = hn::Sub(a.z, b.z);
    return hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
}

template <class D, class M>
HWY_INLINE std::uint32_t bits_of(D d, M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// The verdicts on as many cells as a vector has lanes, a bit a cell, for the cells whose corners a start at particle
/// `at`.
struct Bits {
    std::uint32_t first, second, open;
};

template <class D>
HWY_INLINE Bits judge(D d, const Grid& grid, const Real* const x[3], const Vec3& p, Real reach, int at) {
    using V = hn::Vec<D>;
    constexpr std::uint32_t all = (1u << hn::MaxLanes(d)) - 1;
    constexpr Real rounding = 32 * std::numeric_limits<Real>::epsilon();
    const Corners<V> centre{hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2])};
    const Corners<V> corner_a = corners_at(d, x, at), corner_b = corners_at(d, x, at + 1),
                     corner_c = corners_at(d, x, at + grid.nx), corner_d = corners_at(d, x, at + grid.nx + 1);
    const V from_a = square_between(corner_a, centre), from_b = square_between(corner_b, centre),
            from_c = square_between(corner_c, centre), from_d = square_between(corner_d, centre);
    const V square = hn::Set(d, reach * reach);
    const V diagonal = hn::Min(from_b, from_c);
    Bits bits{bits_of(d, hn::Le(hn::Min(from_a, diagonal), square)),
              bits_of(d, hn::Le(hn::Min(from_d, diagonal), square)), 0};
    if ((bits.first & bits.second) == all) return bits;

    const V nearest = hn::Min(hn::Min(from_a, from_d), diagonal);
    const V sides = hn::Max(hn::Max(square_between(corner_a, corner_b), square_between(corner_a, corner_c)),
                            hn::Max(square_between(corner_d, corner_b), square_between(corner_d, corner_c)));
    const V longest = hn::Max(sides, square_between(corner_b, corner_c));
    const V sure =
        hn::Sub(hn::Mul(nearest, hn::Set(d, 1 - rounding)), hn::Mul(longest, hn::Set(d, (1 + rounding) / 3)));
    bits.open = bits_of(d, hn::Not(hn::Gt(sure, square))) & ~(bits.first & bits.second);
    return bits;
}

/// The number of cells from the k-th on, at most `most`, that follow one another.
HWY_INLINE int run_length(const int* cell, int k, int count, int most) {
    most = HWY_MIN(most, count - k);
    int run = 1;
    while (run < most && cell[k + run] == cell[k] + run) ++run;
    return run;
}

template <class D>
HWY_INLINE void judge_all(D d, const Grid& grid, const Real* const x[3], const Vec3& p, Real reach,
                          std::span<const int> cells, std::uint8_t* verdicts) {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(d));
    const int columns = grid.cell_columns(), count = static_cast<int>(cells.size());
    const int last_start = grid.particles() - 1 - grid.nx - lanes;  // farther on, a vector would leave the arrays
    const int* const cell = cells.data();
    int row = 0, row_begin = 0, row_end = columns;
    for (int k = 0; k < count;) {
        if (cell[k] < row_begin || cell[k] >= row_end) {
            row = cell[k] / columns;
            row_begin = row * columns;
            row_end = row_begin + columns;
        }
        const int run = run_length(cell, k, count, HWY_MIN(lanes, row_end - cell[k]));
        const int wanted = cell[k] + row, at = HWY_MIN(wanted, last_start), skipped = wanted - at;
        const Bits bits = judge(d, grid, x, p, reach, at);
        for (int lane = 0; lane < run; ++lane) {
            const int bit = lane + skipped;
            verdicts[k + lane] = static_cast<std::uint8_t>((bits.first >> bit & 1u) * Verdict::first |
                                                           (bits.second >> bit & 1u) * Verdict::second |
                                                           (bits.open >> bit & 1u) * Verdict::open);
        }
        k += run;
    }
}

void judge_cells_of(const Grid& grid, const Real* const x[3], const Vec3& p, Real reach, std::span<const int> cells,
                    std::uint8_t* verdicts) {
    const hn::CappedTag<Real, 16> widest;
    if (grid.particles() > grid.nx + static_cast<int>(hn::Lanes(widest))) {
        judge_all(widest, grid, x, p, reach, cells, verdicts);
    } else {
        judge_all(hn::CappedTag<Real, 1>(), grid, x, p, reach, cells, verdicts);
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(judge_cells_of);

void judge_cells(const Grid& grid, const Real* const x[3], const Vec3& p, Real reach, std::span<const int> cells,
                 std::uint8_t* verdicts) {
    HWY_DYNAMIC_DISPATCH(judge_cells_of)(grid, x, p, reach, cells, verdicts);
}

}  // namespace drape::kernels
#endif
