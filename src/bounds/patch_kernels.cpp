#include "patch_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bounds/patch_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "patch_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// Columns that are added up together.
constexpr int together = 8;

/// Sums of up to eight columns from column i on, pairwise: column k with k + 4, then k + 2, then k + 1. Columns that
/// are not there count as zero.
template <class D>
HWY_INLINE void add_columns(D d, const Patch& patch, int i, Real total[3]) {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(d));
    const int columns = HWY_MIN(together, patch.columns - i);
    const Real* const from[3] = {patch.x + i, patch.y + i, patch.z + i};
    for (int axis = 0; axis < 3; ++axis) {
        HWY_ALIGN Real sum[together] = {};
        const auto sum_from = [&](int k) HWY_ATTR {
            auto part = hn::Zero(d);
            for (int j = 0; j < patch.rows; ++j) part = hn::Add(part, hn::LoadU(d, from[axis] + j * patch.stride + k));
            hn::StoreU(part, d, sum + k);
        };
        int k = 0;
        for (; k + lanes <= columns; k += lanes) sum_from(k);
        if (k < columns && columns >= lanes) {
            sum_from(columns - lanes);
        } else {
            for (; k < columns; ++k) {
                for (int j = 0; j < patch.rows; ++j) sum[k] += from[axis][j * patch.stride + k];
            }
        }
        for (int half = together / 2; half > 0; half /= 2) {
            for (int lane = 0; lane < half; ++lane) sum[lane] += sum[lane + half];
        }
        total[axis] += sum[0];
    }
}

void mean_of(const Patch& patch, Real centre[3]) {
    const hn::CappedTag<Real, together> d;
    Real total[3] = {};
    for (int i = 0; i < patch.columns; i += together) add_columns(d, patch, i, total);
    for (int axis = 0; axis < 3; ++axis) centre[axis] = total[axis] / static_cast<Real>(patch.particles());
}

/// Of `count` centres together, so that particles are loaded once for all of them.
template <int count, class D>
HWY_INLINE void raise_together(D d, const Patch& patch, const Vec3* centres, Real* squares) {
    hn::Vec<D> far[count];
    for (int k = 0; k < count; ++k) far[k] = hn::Zero(d);
    for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
        for (int k = 0; k < count; ++k) far[k] = hn::Max(far[k], square_to(d, patch, j * patch.stride + i, centres[k]));
    });
    for (int k = 0; k < count; ++k) squares[k] = HWY_MAX(squares[k], largest_lane(d, far[k]));
}

void raise_to_farthest_of(const Patch& patch, const Vec3* centres, int count, Real* squares) {
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        int k = 0;
        for (; k + 4 <= count; k += 4) raise_together<4>(d, patch, centres + k, squares + k);
        for (; k + 2 <= count; k += 2) raise_together<2>(d, patch, centres + k, squares + k);
        for (; k < count; ++k) raise_together<1>(d, patch, centres + k, squares + k);
    });
}

void bounding_box_of(const Patch& patch, Real low[3], Real high[3]) {
    with_vectors_for(patch.columns, [&](auto d) HWY_ATTR {
        const Real* const from[3] = {patch.x, patch.y, patch.z};
        using V = hn::Vec<decltype(d)>;
        V least[3], most[3];
        for (int axis = 0; axis < 3; ++axis) least[axis] = most[axis] = hn::LoadU(d, from[axis]);
        for_each_vector(d, patch, [&](int i, int j) HWY_ATTR {
            for (int axis = 0; axis < 3; ++axis) {
                const V value = hn::LoadU(d, from[axis] + j * patch.stride + i);
                least[axis] = hn::Min(least[axis], value);
                most[axis] = hn::Max(most[axis], value);
            }
        });
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = smallest_lane(d, least[axis]);
            high[axis] = largest_lane(d, most[axis]);
        }
    });
}

Real largest_displacement_square_of(const Patch& now, const Patch& before) {
    Real largest = 0;
    with_vectors_for(now.columns, [&](auto d) HWY_ATTR {
        auto far = hn::Zero(d);
        for_each_vector(d, now, [&](int i, int j) HWY_ATTR {
            const int a = j * now.stride + i, b = j * before.stride + i;
            const auto dx = hn::Sub(hn::LoadU(d, now.x + a), hn::LoadU(d, before.x + b));
            const auto dy = hn::Sub(hn::LoadU(d, now.y + a), hn::LoadU(d, before.y + b));
            const auto dz = hn::Sub(hn::LoadU(d, now.z + a), hn::LoadU(d, before.z + b));
            far = hn::Max(far, hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz)));
        });
        largest = largest_lane(d, far);
    });
    return largest;
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(mean_of);
HWY_EXPORT(raise_to_farthest_of);
HWY_EXPORT(bounding_box_of);
HWY_EXPORT(largest_displacement_square_of);

void mean(const Patch& patch, Real centre[3]) { HWY_DYNAMIC_DISPATCH(mean_of)(patch, centre); }

void raise_to_farthest(const Patch& patch, const Vec3* centres, int count, Real* squares) {
    HWY_DYNAMIC_DISPATCH(raise_to_farthest_of)(patch, centres, count, squares);
}

void bounding_box(const Patch& patch, Real low[3], Real high[3]) {
    HWY_DYNAMIC_DISPATCH(bounding_box_of)(patch, low, high);
}

Real largest_displacement_square(const Patch& now, const Patch& before) {
    return HWY_DYNAMIC_DISPATCH(largest_displacement_square_of)(now, before);
}

}  // namespace drape::kernels
#endif
