#include "extent_kernels.h"

#include <limits>
#include <utility>

#include "drape/bounds/dop_axes.h"
#include "patch_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bounds/kernels/extent_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "patch_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// The terms of a sum so far, and one more: added, taken off or left out. In the order of `dop_projection`.
template <int factor, class V>
HWY_INLINE V plus(V sum, V term) {
    if constexpr (factor > 0)
        return hn::Add(sum, term);
    else if constexpr (factor < 0)
        return hn::Sub(sum, term);
    else
        return sum;
}

template <int number, class V>
HWY_INLINE V projection(V x, V y, V z) {
    constexpr auto axis = dop_axes[number];
    if constexpr (axis[0] != 0)
        return plus<axis[2]>(plus<axis[1]>(x, y), z);
    else if constexpr (axis[1] != 0)
        return plus<axis[2]>(y, z);
    else
        return z;
}

template <int K, std::size_t... k>
HWY_INLINE void extents(const Patch& patch, Real* low, Real* high, std::index_sequence<k...>) {
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        using V = hn::Vec<decltype(d)>;
        V least[K / 2], most[K / 2];
        ((least[k] = hn::Set(d, std::numeric_limits<Real>::infinity()), most[k] = hn::Neg(least[k])), ...);
        for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
            const int p = j * patch.stride + i;
            const V x = hn::LoadU(d, patch.x + p), y = hn::LoadU(d, patch.y + p), z = hn::LoadU(d, patch.z + p);
            const V projections[] = {projection<dop_numbers<K>[k]>(x, y, z)...};
            ((least[k] = hn::Min(least[k], projections[k]), most[k] = hn::Max(most[k], projections[k])), ...);
        });
        ((low[k] = smallest_lane(d, least[k]), high[k] = largest_lane(d, most[k])), ...);
    });
}

void dop_extents_of(const Patch& patch, int slabs, Real* low, Real* high) {
    if (slabs == 7)
        extents<14>(patch, low, high, std::make_index_sequence<7>());
    else if (slabs == 9)
        extents<18>(patch, low, high, std::make_index_sequence<9>());
    else
        extents<26>(patch, low, high, std::make_index_sequence<13>());
}

void extents_along_of(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high) {
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        using V = hn::Vec<decltype(d)>;
        V least[3], most[3];
        for (int k = 0; k < 3; ++k) {
            least[k] = hn::Set(d, std::numeric_limits<Real>::infinity());
            most[k] = hn::Neg(least[k]);
        }
        for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
            const int p = j * patch.stride + i;
            const V dx = hn::Sub(hn::LoadU(d, patch.x + p), hn::Set(d, origin[0]));
            const V dy = hn::Sub(hn::LoadU(d, patch.y + p), hn::Set(d, origin[1]));
            const V dz = hn::Sub(hn::LoadU(d, patch.z + p), hn::Set(d, origin[2]));
            for (int k = 0; k < 3; ++k) {
                const V along = hn::Add(hn::Mul(dx, hn::Set(d, axes(0, k))), hn::Mul(dy, hn::Set(d, axes(1, k))));
                const V sum = hn::Add(along, hn::Mul(dz, hn::Set(d, axes(2, k))));
                least[k] = hn::Min(least[k], sum);
                most[k] = hn::Max(most[k], sum);
            }
        });
        for (int k = 0; k < 3; ++k) {
            low[k] = smallest_lane(d, least[k]);
            high[k] = largest_lane(d, most[k]);
        }
    });
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(dop_extents_of);
HWY_EXPORT(extents_along_of);

void dop_extents(const Patch& patch, int slabs, Real* low, Real* high) {
    if (slabs == 3) return bounding_box(patch, low, high);
    HWY_DYNAMIC_DISPATCH(dop_extents_of)(patch, slabs, low, high);
}

void extents_along(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high) {
    HWY_DYNAMIC_DISPATCH(extents_along_of)(patch, origin, axes, low, high);
}

}  // namespace drape::kernels
#endif
