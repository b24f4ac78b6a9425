#include "near_cells.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/kernels/near_cells.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE Lanes3<hn::Vec<D>> corners_at(D d, const Real* const x[3], int at) {
    return {hn::LoadU(d, x[0] + at), hn::LoadU(d, x[1] + at), hn::LoadU(d, x[2] + at)};
}

template <class V>
HWY_INLINE V square_between(const Lanes3<V>& a, const Lanes3<V>& b) {
    const Lanes3<V> offset = minus(a, b);
    return dot(offset, offset);
}

/// The bits of as many cells as a vector has lanes; corner a of the first is particle `at`.
/// @param wanted the cells that matter, a bit each
template <class D>
HWY_INLINE CellBits classify(D d, const Grid& grid, const Real* const x[3], const Vec3& p, Real radius, int at,
                             std::uint32_t wanted) {
    using V = hn::Vec<D>;
    constexpr Real rounding = 32 * std::numeric_limits<Real>::epsilon();
    const Lanes3<V> centre{hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2])};
    const Lanes3<V> corner_a = corners_at(d, x, at), corner_b = corners_at(d, x, at + 1),
                    corner_c = corners_at(d, x, at + grid.nx), corner_d = corners_at(d, x, at + grid.nx + 1);
    const V from_a = square_between(corner_a, centre), from_b = square_between(corner_b, centre),
            from_c = square_between(corner_c, centre), from_d = square_between(corner_d, centre);
    const V square = hn::Set(d, radius * radius);
    const V diagonal = hn::Min(from_b, from_c);
    CellBits bits{0, 0, lane_bits(d, hn::Le(hn::Min(from_a, diagonal), square)),
                  lane_bits(d, hn::Le(hn::Min(from_d, diagonal), square)), 0};
    if ((bits.first & bits.second & wanted) == wanted) return bits;

    const V nearest = hn::Min(hn::Min(from_a, from_d), diagonal);
    const V sides = hn::Max(hn::Max(square_between(corner_a, corner_b), square_between(corner_a, corner_c)),
                            hn::Max(square_between(corner_d, corner_b), square_between(corner_d, corner_c)));
    const V longest = hn::Max(sides, square_between(corner_b, corner_c));
    const V sure =
        hn::Sub(hn::Mul(nearest, hn::Set(d, 1 - rounding)), hn::Mul(longest, hn::Set(d, (1 + rounding) / 3)));
    bits.undecided = lane_bits(d, hn::Not(hn::Gt(sure, square))) & ~(bits.first & bits.second);
    return bits;
}

template <class D>
HWY_INLINE int classify_all(D d, const Grid& grid, const Real* const x[3], const Vec3& p, Real radius,
                            std::span<const CellRun> cells, CellBits* bits) {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(d));
    const int last_start = grid.particles() - 1 - grid.nx - lanes;  // farther on, a vector would leave the arrays
    int found = 0;
    for (const CellRun& run : cells) {
        const int cell = run.row * grid.cell_columns() + run.column, corner = grid.particle(run.column, run.row);
        for (int k = 0; k < run.count; k += lanes) {
            const int at = HWY_MIN(corner + k, last_start), skipped = corner + k - at;
            const int count = HWY_MIN(lanes, run.count - k);
            const std::uint32_t wanted = (1u << count) - 1;
            const CellBits some = classify(d, grid, x, p, radius, at, wanted << skipped);
            bits[found] = {cell + k, count, some.first >> skipped & wanted, some.second >> skipped & wanted,
                           some.undecided >> skipped & wanted};
            found += bits[found].near() != 0;
        }
    }
    return found;
}

int classify_cells_of(const Grid& grid, const Real* const x[3], const Vec3& p, Real radius,
                      std::span<const CellRun> cells, CellBits* bits) {
    const hn::CappedTag<Real, 16> widest;
    return grid.particles() > grid.nx + static_cast<int>(hn::Lanes(widest))
               ? classify_all(widest, grid, x, p, radius, cells, bits)
               : classify_all(hn::CappedTag<Real, 1>(), grid, x, p, radius, cells, bits);
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
