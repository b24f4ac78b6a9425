#include "patch_kernels.h"

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

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(sums_of);
HWY_EXPORT(raise_to_farthest_of);

PatchSums sums(const Patch& patch) { return HWY_DYNAMIC_DISPATCH(sums_of)(patch); }

void raise_to_farthest(const Patch& patch, const Vec3* centres, int count, Real* squares) {
    HWY_DYNAMIC_DISPATCH(raise_to_farthest_of)(patch, centres, count, squares);
}

}  // namespace drape::kernels
#endif
