#include "patch_kernels.h"

#include <limits>
#include <utility>

#include "bounds/kernels/patch_loop-inl.h"
#include "drape/bounds/dop_axes.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// Columns that are added up together, whatever the width of the vectors.
constexpr int eight = 8;

HWY_INLINE Real pairwise_total(const Real* of) {
    return ((of[0] + of[4]) + (of[2] + of[6])) + ((of[1] + of[5]) + (of[3] + of[7]));
}

/// The sums of one coordinate.
template <class D>
HWY_INLINE void axis_sums(D d, const Patch& patch, const Real* from, Real& inner_total, Real& right,
                          Real& below_total) {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(D()));
    // Of a short row eight can be read all the same, where the next one goes so far: what is too much is left out
    const bool reads_eight = patch.stride + patch.columns >= eight;
    Real inner[eight] = {}, below[eight] = {};
    for (int counted = 0; counted < patch.columns; counted += eight) {
        // The last eight start early enough to end with the row; what was counted before is left out
        const int i = HWY_MAX(0, HWY_MIN(counted, patch.columns - eight)), corner = patch.columns - 1 - i;
        HWY_ALIGN Real column[eight] = {};
        const auto add_rows = [&](auto width, int k) HWY_ATTR {
            auto sum = hn::LoadU(width, from + i + k);
            for (int j = 1; j + 1 < patch.rows; ++j) {
                sum = hn::Add(sum, hn::LoadU(width, from + j * patch.stride + i + k));
            }
            hn::StoreU(sum, width, column + k);
        };
        for (int k = 0; reads_eight && k < eight; k += lanes) add_rows(d, k);
        for (int k = 0; !reads_eight && k < patch.columns; ++k) add_rows(hn::CappedTag<Real, 1>(), k);
        const Real* const last = from + (patch.rows - 1) * patch.stride + i;
        for (int k = counted - i; k < HWY_MIN(corner, eight); ++k) {
            inner[k] += column[k];
            below[k] += last[k];
        }
        if (corner < eight) right = column[corner];
    }
    inner_total = pairwise_total(inner);
    below_total = pairwise_total(below);
}

PatchSums sums_of(const Patch& patch) {
    PatchSums sums;
    const Real* const from[3] = {patch.x, patch.y, patch.z};
    for (int axis = 0; axis < 3; ++axis) {
        axis_sums(hn::CappedTag<Real, eight>(), patch, from[axis], sums.inner[axis], sums.right[axis],
                  sums.below[axis]);
    }
    return sums;
}

/// Of `count` centres together, so that particles are loaded once for all of them.
template <int count, class D>
HWY_INLINE void raise_together(D d, const Patch& patch, const Vec3* centres, Real* squares) {
    hn::Vec<D> far[count];
    for (int k = 0; k < count; ++k) far[k] = hn::Zero(d);
    for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
        const auto particles = particles_from(d, patch, j * patch.stride + i);
        for (int k = 0; k < count; ++k) {
            const auto offset = minus(particles, in_each_lane(d, centres[k]));
            far[k] = hn::Max(far[k], dot(offset, offset));
        }
    });
    for (int k = 0; k < count; ++k) squares[k] = HWY_MAX(squares[k], hn::GetLane(hn::MaxOfLanes(d, far[k])));
}

void raise_to_farthest_of(const Patch& patch, const Vec3* centres, int count, Real* squares) {
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        int k = 0;
        for (; k + 4 <= count; k += 4) raise_together<4>(d, patch, centres + k, squares + k);
        for (; k + 2 <= count; k += 2) raise_together<2>(d, patch, centres + k, squares + k);
        for (; k < count; ++k) raise_together<1>(d, patch, centres + k, squares + k);
    });
}

/// Some figures of each particle of a vector.
template <class V, std::size_t count>
struct Figures {
    V figure[count];
};

/// The smallest and the largest of each figure.
/// @param figures_at called as figures_at(d, p) for the vector of particles from p on
template <std::size_t... k, class FiguresAt>
HWY_INLINE void extents(const Patch& patch, Real* low, Real* high, std::index_sequence<k...>, FiguresAt figures_at) {
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        using V = hn::Vec<decltype(d)>;
        V least[sizeof...(k)], most[sizeof...(k)];
        ((least[k] = hn::Set(d, std::numeric_limits<Real>::infinity()), most[k] = hn::Neg(least[k])), ...);
        for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
            const auto of = figures_at(d, j * patch.stride + i);
            ((least[k] = hn::Min(least[k], of.figure[k]), most[k] = hn::Max(most[k], of.figure[k])), ...);
        });
        ((low[k] = hn::GetLane(hn::MinOfLanes(d, least[k])), high[k] = hn::GetLane(hn::MaxOfLanes(d, most[k]))), ...);
    });
}

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
HWY_INLINE void dop_extents_in(const Patch& patch, Real* low, Real* high, std::index_sequence<k...> each) {
    extents(patch, low, high, each, [&](auto d, int p) HWY_ATTR {
        using V = hn::Vec<decltype(d)>;
        const V x = loaded_once(hn::LoadU(d, patch.x + p)), y = loaded_once(hn::LoadU(d, patch.y + p)),
                z = loaded_once(hn::LoadU(d, patch.z + p));
        return Figures<V, K / 2>{{projection<dop_numbers<K>[k]>(x, y, z)...}};
    });
}

void dop_extents_of(const Patch& patch, int slabs, Real* low, Real* high) {
    if (slabs == 3)
        dop_extents_in<6>(patch, low, high, std::make_index_sequence<3>());
    else if (slabs == 7)
        dop_extents_in<14>(patch, low, high, std::make_index_sequence<7>());
    else if (slabs == 9)
        dop_extents_in<18>(patch, low, high, std::make_index_sequence<9>());
    else
        dop_extents_in<26>(patch, low, high, std::make_index_sequence<13>());
}

void extents_along_of(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high) {
    extents(patch, low, high, std::make_index_sequence<3>(), [&](auto d, int p) HWY_ATTR {
        const auto offset = minus(particles_from(d, patch, p), in_each_lane(d, origin));
        Figures<hn::Vec<decltype(d)>, 3> along;
        for (int k = 0; k < 3; ++k) along.figure[k] = dot(offset, in_each_lane(d, axes.data() + 3 * k));
        return along;
    });
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(sums_of);
HWY_EXPORT(raise_to_farthest_of);
HWY_EXPORT(dop_extents_of);
HWY_EXPORT(extents_along_of);

PatchSums sums(const Patch& patch) { return HWY_DYNAMIC_DISPATCH(sums_of)(patch); }

void raise_to_farthest(const Patch& patch, const Vec3* centres, int count, Real* squares) {
    HWY_DYNAMIC_DISPATCH(raise_to_farthest_of)(patch, centres, count, squares);
}

void dop_extents(const Patch& patch, int slabs, Real* low, Real* high) {
    HWY_DYNAMIC_DISPATCH(dop_extents_of)(patch, slabs, low, high);
}

void extents_along(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high) {
    HWY_DYNAMIC_DISPATCH(extents_along_of)(patch, origin, axes, low, high);
}

}  // namespace drape::kernels
#endif
