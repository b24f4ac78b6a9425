#include "near_cells.h"

#include <limits>

#include "bounds/kernels/patch_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// The square of the longest side of a row of cells, diagonals not counted; sides without a length are left out.
HWY_INLINE Real longest_side_square(const Patch& corners) {
    Real square = 0;
    const Patch cells{corners.x, corners.y, corners.z, corners.columns - 1, 1, corners.stride};
    with_vectors_for(cells.columns, [&](auto d) HWY_ATTR {
        const auto particles = [&](int p) HWY_ATTR { return particles_from(d, cells, p); };
        auto longest = hn::Zero(d);
        // Where the first of two is not a number, x86 takes the second; elsewhere all cells are near
        const auto see = [&](const auto& from, const auto& to) HWY_ATTR {
            const auto side = minus(from, to);
            longest = hn::Max(dot(side, side), longest);
        };
        for_each_vector(d, cells, [&](int i, int) HWY_ATTR {
            const auto above = particles(i), above_next = particles(i + 1);
            const auto below = particles(i + cells.stride), below_next = particles(i + 1 + cells.stride);
            see(above, above_next);
            see(above, below);
            see(below, below_next);
            see(above_next, below_next);
        });
        square = largest_lane(d, longest);
    });
    return square;
}

std::uint32_t near_cells_of(const Patch& corners, const Vec3& p, Real radius) {
    constexpr Real rounding = 32 * std::numeric_limits<Real>::epsilon();
    const Real beyond = radius * radius + (1 + rounding) * longest_side_square(corners);
    std::uint32_t far[2] = {};  // of the particles of both rows
    with_vectors_for(corners.columns, [&](auto d) HWY_ATTR {
        const auto limit = hn::Set(d, beyond), shrink = hn::Set(d, 1 - rounding);
        for_each_vector(d, corners, [&](int i, int j) HWY_ATTR {
            const auto square = square_to(d, corners, j * corners.stride + i, p);
            far[j] |= lane_bits(d, hn::Gt(hn::Mul(square, shrink), limit)) << i;
        });
    });
    const std::uint32_t near = ~(far[0] & far[1]), cells = (std::uint32_t{1} << (corners.columns - 1)) - 1;
    return (near | near >> 1) & cells;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(near_cells_of);

std::uint32_t near_cells(const Patch& corners, const Vec3& p, Real radius) {
    return HWY_DYNAMIC_DISPATCH(near_cells_of)(corners, p, radius);
}

}  // namespace drape::kernels
#endif
