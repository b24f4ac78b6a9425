#include "patch_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bounds/patch_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "patch_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// Columns that are added up together, whatever the width of the vectors.
constexpr int eight = 8;

HWY_INLINE Real pairwise_total(Real* lane) {
    for (int half = eight / 2; half > 0; half /= 2) {
        for (int k = 0; k < half; ++k) lane[k] += lane[k + half];
    }
    return lane[0];
}

/// Sums of the eight columns from `from` on, without the last row, and the particles of that.
template <class D>
HWY_INLINE void add_up_eight(D d, const Real* from, int rows, int stride, Real* column, Real* last) {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(d));
    for (int k = 0; k < eight; k += lanes) {
        auto sum = hn::Zero(d);
        for (int j = 0; j + 1 < rows; ++j) sum = hn::Add(sum, hn::LoadU(d, from + j * stride + k));
        hn::Store(sum, d, column + k);
        hn::Store(hn::LoadU(d, from + (rows - 1) * stride + k), d, last + k);
    }
}

HWY_INLINE void add_up_few(const Real* from, int columns, int rows, int stride, Real* column, Real* last) {
    for (int k = 0; k < eight; ++k) column[k] = last[k] = 0;
    for (int j = 0; j + 1 < rows; ++j) {
        for (int k = 0; k < columns; ++k) column[k] += from[j * stride + k];
    }
    for (int k = 0; k < columns; ++k) last[k] = from[(rows - 1) * stride + k];
}

/// The sums of one coordinate.
HWY_INLINE void axis_sums(const Patch& patch, const Real* from, Real& inner_sum, Real& right, Real& below_sum) {
    const hn::CappedTag<Real, eight> d;
    HWY_ALIGN Real inner[eight] = {}, below[eight] = {}, column[eight], last[eight];
    for (int counted = 0; counted < patch.columns; counted += eight) {
        // The last eight start early enough to end with the row; what was counted before is left out
        const int i = patch.columns >= eight ? HWY_MIN(counted, patch.columns - eight) : 0;
        if (patch.columns >= eight)
            add_up_eight(d, from + i, patch.rows, patch.stride, column, last);
        else
            add_up_few(from, patch.columns, patch.rows, patch.stride, column, last);
        for (int k = 0; k < counted - i; ++k) column[k] = last[k] = 0;
        if (const int corner = patch.columns - 1 - i; corner < eight) {
            right = column[corner];
            column[corner] = last[corner] = 0;
        }
        for (int k = 0; k < eight; ++k) inner[k] += column[k], below[k] += last[k];
    }
    inner_sum = pairwise_total(inner);
    below_sum = pairwise_total(below);
}

PatchSums sums_of(const Patch& patch) {
    PatchSums sums;
    const Real* const from[3] = {patch.x, patch.y, patch.z};
    for (int axis = 0; axis < 3; ++axis) {
        axis_sums(patch, from[axis], sums.inner[axis], sums.right[axis], sums.below[axis]);
    }
    return sums;
}

template <class D>
HWY_INLINE hn::Vec<D> square_to(D d, const Patch& patch, int start, const Vec3& centre) {
    const auto dx = hn::Sub(hn::LoadU(d, patch.x + start), hn::Set(d, centre[0]));
    const auto dy = hn::Sub(hn::LoadU(d, patch.y + start), hn::Set(d, centre[1]));
    const auto dz = hn::Sub(hn::LoadU(d, patch.z + start), hn::Set(d, centre[2]));
    return hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
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

HWY_EXPORT(sums_of);
HWY_EXPORT(raise_to_farthest_of);
HWY_EXPORT(bounding_box_of);
HWY_EXPORT(largest_displacement_square_of);

PatchSums sums(const Patch& patch) { return HWY_DYNAMIC_DISPATCH(sums_of)(patch); }

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
