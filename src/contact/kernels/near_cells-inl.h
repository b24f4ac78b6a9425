#include "near_cells.h"

#include <limits>

#include "bounds/kernels/patch_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

std::uint32_t near_cells_of(const Patch& corners, const Vec3& p, Real radius) {
    constexpr Real rounding = 32 * std::numeric_limits<Real>::epsilon();
    const Patch cells{corners.x, corners.y, corners.z, corners.columns - 1, 1, corners.stride};
    std::uint32_t far = 0;
    with_vectors_for(cells.columns, [&](auto d) HWY_ATTR {
        const auto point = in_each_lane(d, p);
        const auto square_between = [](const auto& from, const auto& to) HWY_ATTR {
            const auto offset = minus(from, to);
            return dot(offset, offset);
        };
        for_each_vector(d, cells, [&](int i, int) HWY_ATTR {
            const auto above = particles_from(d, cells, i), above_next = particles_from(d, cells, i + 1);
            const auto below = particles_from(d, cells, i + cells.stride);
            const auto below_next = particles_from(d, cells, i + 1 + cells.stride);
            const auto nearest = hn::Min(hn::Min(square_between(above, point), square_between(above_next, point)),
                                         hn::Min(square_between(below, point), square_between(below_next, point)));
            const auto longest =
                hn::Max(hn::Max(square_between(above, above_next), square_between(above, below)),
                        hn::Max(square_between(below, below_next), square_between(above_next, below_next)));
            const auto beyond = hn::Add(hn::Set(d, radius * radius), hn::Mul(hn::Set(d, 1 + rounding), longest));
            far |= lane_bits(d, hn::Gt(hn::Mul(nearest, hn::Set(d, 1 - rounding)), beyond)) << i;
        });
    });
    return ~far & ((std::uint32_t{1} << cells.columns) - 1);
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
