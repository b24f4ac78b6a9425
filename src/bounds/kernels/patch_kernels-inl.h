#include "patch_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// Columns that are added up together, whatever the width of the vectors.
constexpr int eight = 8;

/// Eight values in as many vectors as they take.
template <class D>
struct Eight {
    static constexpr int lanes = static_cast<int>(hn::MaxLanes(D()));
    static constexpr int vectors = eight / lanes;
    hn::Vec<D> vector[vectors];
};

/// Eight values; those from `count` on are zero and not read.
template <class D>
HWY_INLINE Eight<D> load_eight(D d, const Real* from, int count) {
    Eight<D> values;
    HWY_ALIGN Real few[eight] = {};
    if (count < eight) {
        for (int k = 0; k < count; ++k) few[k] = from[k];
        from = few;
    }
    for (int p = 0; p < Eight<D>::vectors; ++p) values.vector[p] = hn::LoadU(d, from + p * Eight<D>::lanes);
    return values;
}

/// sum += values, but for those before `begin` and from `end` on.
template <class D>
HWY_INLINE void add_between(D d, const Eight<D>& values, int begin, int end, Eight<D>& sum) {
    for (int p = 0; p < Eight<D>::vectors; ++p) {
        const auto number = hn::Iota(d, static_cast<Real>(p * Eight<D>::lanes));
        const auto counts = hn::And(hn::Ge(number, hn::Set(d, static_cast<Real>(begin))),
                                    hn::Lt(number, hn::Set(d, static_cast<Real>(end))));
        sum.vector[p] = hn::Add(sum.vector[p], hn::IfThenElseZero(counts, values.vector[p]));
    }
}

template <class D>
HWY_INLINE void store_eight(D d, const Eight<D>& values, Real* to) {
    for (int p = 0; p < Eight<D>::vectors; ++p) hn::StoreU(values.vector[p], d, to + p * Eight<D>::lanes);
}

template <class Lane>
HWY_INLINE Real pairwise_total(Lane lane) {
    return ((lane(0) + lane(4)) + (lane(2) + lane(6))) + ((lane(1) + lane(5)) + (lane(3) + lane(7)));
}

template <class D>
HWY_INLINE Real pairwise_total(D d, const Eight<D>& values) {
    Real lane[eight];
    store_eight(d, values, lane);
    return pairwise_total([&](int k) HWY_ATTR { return lane[k]; });
}

/// The sums of one coordinate.
template <class D>
HWY_INLINE void axis_sums(D d, const Patch& patch, const Real* from, Real& inner_total, Real& right,
                          Real& below_total) {
    Eight<D> inner = load_eight(d, from, 0), below = inner;
    // Of a short row that another one follows, eight can be read all the same: what is too much is left out of the
    // sums. To copy the few would be slower, for a vector that is loaded where single values were just stored waits for
    // them
    const bool follows = patch.rows > 1 && patch.stride + patch.columns >= eight;
    for (int counted = 0; counted < patch.columns; counted += eight) {
        // The last eight start early enough to end with the row; what was counted before is left out
        const int i = HWY_MAX(0, HWY_MIN(counted, patch.columns - eight));
        const int count = HWY_MIN(eight, patch.columns - i), corner = patch.columns - 1 - i;
        const int read = follows ? eight : count;
        Eight<D> column = load_eight(d, from + i, read);
        for (int j = 1; j + 1 < patch.rows; ++j) {
            const Eight<D> row = load_eight(d, from + j * patch.stride + i, read);
            for (int p = 0; p < Eight<D>::vectors; ++p) column.vector[p] = hn::Add(column.vector[p], row.vector[p]);
        }
        add_between(d, column, counted - i, corner, inner);
        const Real* const last = from + (patch.rows - 1) * patch.stride + i;
        if (count < eight) {
            below_total = pairwise_total([&](int k) HWY_ATTR { return k < corner ? last[k] : 0; });
        } else {
            add_between(d, load_eight(d, last, count), counted - i, corner, below);
        }
        if (corner < eight) {
            Real lane[eight];
            store_eight(d, column, lane);
            right = lane[corner];
        }
    }
    inner_total = pairwise_total(d, inner);
    if (patch.columns >= eight) below_total = pairwise_total(d, below);
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

Real largest_displacement_square_of(const Patch& now, const Patch& before) {
    Real largest = 0;
    with_vectors_for(now.columns, [&](auto d) HWY_ATTR {
        auto far = hn::Zero(d);
        for_each_vector(d, now, [&](int i, int j) HWY_ATTR {
            const auto moved =
                minus(particles_from(d, now, j * now.stride + i), particles_from(d, before, j * before.stride + i));
            far = hn::Max(far, dot(moved, moved));
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
HWY_EXPORT(largest_displacement_square_of);

PatchSums sums(const Patch& patch) { return HWY_DYNAMIC_DISPATCH(sums_of)(patch); }

void raise_to_farthest(const Patch& patch, const Vec3* centres, int count, Real* squares) {
    HWY_DYNAMIC_DISPATCH(raise_to_farthest_of)(patch, centres, count, squares);
}

Real largest_displacement_square(const Patch& now, const Patch& before) {
    return HWY_DYNAMIC_DISPATCH(largest_displacement_square_of)(now, before);
}

}  // namespace drape::kernels
#endif
