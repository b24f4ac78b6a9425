#include "force_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/force_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/assert.h"
#include "drape/model/stencils.h"
#include "force_scratch.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Triple {
    V x, y, z;
};

template <class D>
HWY_INLINE Triple<hn::Vec<D>> load(D d, const Rows& rows, int i) {
    return {hn::LoadU(d, rows[0] + i), hn::LoadU(d, rows[1] + i), hn::LoadU(d, rows[2] + i)};
}

template <class D>
HWY_INLINE void store(const Triple<hn::Vec<D>>& values, D d, const Rows& rows, int i) {
    hn::StoreU(values.x, d, rows[0] + i);
    hn::StoreU(values.y, d, rows[1] + i);
    hn::StoreU(values.z, d, rows[2] + i);
}

template <class V>
HWY_INLINE Triple<V> plus(const Triple<V>& a, const Triple<V>& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template <class V>
HWY_INLINE Triple<V> minus(const Triple<V>& a, const Triple<V>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class V>
HWY_INLINE Triple<V> times(const Triple<V>& a, V factor) {
    return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}

template <class V>
HWY_INLINE V dot(const Triple<V>& a, const Triple<V>& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

/// Copies some numbers, of which the last vector may reach back into the one before.
HWY_INLINE void copy(const Real* from, int count, Real* to) {
    const hn::CappedTag<Real, Scratch::margin> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    if (count < lanes) {
        for (int i = 0; i < count; ++i) to[i] = from[i];
        return;
    }
    for (int i = 0; i + lanes <= count; i += lanes) hn::StoreU(hn::LoadU(d, from + i), d, to + i);
    hn::StoreU(hn::LoadU(d, from + count - lanes), d, to + count - lanes);
}

/// Copies a row of particles into its slot. Rows that the cloth does not have are left at zero.
HWY_INLINE void copy_row(const ForceInput& input, const Strip& strip, int row, const Scratch& scratch) {
    if (row >= strip.grid.ny) return;
    const int slot = strip.slot(row), p = strip.grid.particle(strip.first, row), count = strip.end - strip.first;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        copy(input.x[axis] + p, count, scratch.x(slot)[axis] + Scratch::margin);
        copy(input.v[axis] + p, count, scratch.v(slot)[axis] + Scratch::margin);
        if (input.wind[0] != nullptr) copy(input.wind[axis] + p, count, scratch.wind(slot)[axis] + Scratch::margin);
    }
}

void copy_neighbours(const ForceInput& input, const Part& part, const Scratch& scratch) {
    const Strip strip(part, input.model->grid);
    for (int row = std::max(part.first_row - 2, 0); row < part.first_row; ++row) copy_row(input, strip, row, scratch);
    for (int row = strip.end_row; row < strip.end_row + 2; ++row) copy_row(input, strip, row, scratch);
}

/// Two kinds of spring of one law, from the same first ends.
struct SpringPair {
    SpringLaw law;
    Real rest_length[2];
    Rows x[2], v[2];  // of the row of the second ends
    int di[2];
    const Real* there[2];  // 1 where the cloth holds the second end, else 0
    Rows pull[2];
};

HWY_INLINE SpringPair spring_pair(const std::array<SpringStencil, 6>& springs, int first, const Strip& strip, int j,
                                  const Scratch& scratch) {
    SpringPair pair;
    pair.law = springs[static_cast<std::size_t>(first)].law;
    for (int s = 0; s < 2; ++s) {
        const SpringStencil& spring = springs[static_cast<std::size_t>(first + s)];
        pair.rest_length[s] = spring.rest_length;
        pair.x[s] = scratch.x(strip.slot(j + spring.dj));
        pair.v[s] = scratch.v(strip.slot(j + spring.dj));
        pair.di[s] = spring.di;
        pair.there[s] = j + spring.dj < strip.grid.ny ? scratch.there(first + s) : scratch.zeros();
        pair.pull[s] = scratch.pulls(first + s, j);
    }
    return pair;
}

/// Finds the pulls of two springs, (k - k L0/|d| + c d.dv/|d|^2) d with d = x_a - x_b and dv = v_a - v_b, and takes
/// them from the force on a. One division serves both lengths. A zero length is lifted to a tiny one, of which even the
/// product with another has a finite inverse; the pull is zero, as d is.
template <class D>
HWY_INLINE void pull(D d, const SpringPair& pair, const Triple<hn::Vec<D>>& x, const Triple<hn::Vec<D>>& v, int i,
                     Triple<hn::Vec<D>>& force) {
    const auto k = hn::Set(d, pair.law.stiffness), c = hn::Set(d, pair.law.damping);
    const auto tiny = hn::Set(d, std::sqrt(std::numeric_limits<Real>::min()));
    const auto d0 = minus(x, load(d, pair.x[0], i + pair.di[0])), d1 = minus(x, load(d, pair.x[1], i + pair.di[1]));
    const auto length0 = hn::Max(hn::Sqrt(dot(d0, d0)), tiny), length1 = hn::Max(hn::Sqrt(dot(d1, d1)), tiny);
    const auto inverse = hn::Div(hn::Set(d, Real(1)), hn::Mul(length0, length1));
    const auto finish = [&](int s, const auto& offset, auto one_over_length) HWY_ATTR {
        const auto closing = dot(offset, minus(v, load(d, pair.v[s], i + pair.di[s])));
        const auto rest = hn::Set(d, pair.law.stiffness * pair.rest_length[s]);
        const auto damping = hn::Mul(hn::Mul(hn::Mul(c, closing), one_over_length), one_over_length);
        const auto factor = hn::Add(hn::Sub(k, hn::Mul(rest, one_over_length)), damping);
        const auto found = times(offset, hn::Mul(factor, hn::LoadU(d, pair.there[s] + i)));
        store(found, d, pair.pull[s], i);
        force = minus(force, found);
    };
    finish(0, d0, hn::Mul(inverse, length1));
    finish(1, d1, hn::Mul(inverse, length0));
}

/// Finds the pulls of all springs whose first ends lie in row j, and adds them up there, with gravity, drag and wind.
template <bool windy>
HWY_INLINE void find_pulls(const ForceInput& input, const Strip& strip, const std::array<SpringStencil, 6>& springs,
                           int j, const Scratch& scratch) {
    const hn::CappedTag<Real, Scratch::margin> d;
    const SpringPair structural = spring_pair(springs, 0, strip, j, scratch);
    const SpringPair shear = spring_pair(springs, 2, strip, j, scratch);
    const SpringPair bend = spring_pair(springs, 4, strip, j, scratch);
    const bool has[3] = {structural.law != SpringLaw{}, shear.law != SpringLaw{}, bend.law != SpringLaw{}};
    const Rows row_x = scratch.x(strip.slot(j)), row_v = scratch.v(strip.slot(j)), wind = scratch.wind(strip.slot(j));
    const Rows force = scratch.force();
    const Vec3 weight = input.model->particle_mass * input.model->gravity;
    const Real drag = input.model->drag;
    const int end = strip.at(strip.last);
    for (int i = Scratch::margin; i < end; i += static_cast<int>(hn::Lanes(d))) {
        const auto x = load(d, row_x, i), v = load(d, row_v, i);
        Triple<hn::Vec<decltype(d)>> f{hn::Set(d, weight[0]), hn::Set(d, weight[1]), hn::Set(d, weight[2])};
        f = minus(f, times(v, hn::Set(d, drag)));
        if constexpr (windy) f = plus(f, load(d, wind, i));
        if (has[0]) pull(d, structural, x, v, i, f);
        if (has[1]) pull(d, shear, x, v, i, f);
        if (has[2]) pull(d, bend, x, v, i, f);
        store(f, d, force, i);
    }
}

/// Adds the pulls at the second ends of the springs that end in row j. No pulls were found of springs without a law,
/// nor of those from before the first row.
HWY_INLINE void add_up(const Strip& strip, const std::array<SpringStencil, 6>& springs, int j, const Scratch& scratch) {
    const hn::CappedTag<Real, Scratch::margin> d;
    const int end = strip.at(strip.last);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real* from[6];
        for (int s = 0; s < 6; ++s) {
            const SpringStencil& spring = springs[static_cast<std::size_t>(s)];
            const bool found = spring.law != SpringLaw{} && j >= spring.dj;
            from[s] = (found ? scratch.pulls(s, j - spring.dj)[axis] : scratch.zeros()) - spring.di;
        }
        Real* const force = scratch.force()[axis];
        for (int i = Scratch::margin; i < end; i += static_cast<int>(hn::Lanes(d))) {
            auto f = hn::Add(hn::LoadU(d, force + i), hn::LoadU(d, from[0] + i));
            f = hn::Add(f, hn::LoadU(d, from[1] + i));
            f = hn::Add(f, hn::LoadU(d, from[2] + i));
            f = hn::Add(f, hn::LoadU(d, from[3] + i));
            f = hn::Add(f, hn::LoadU(d, from[4] + i));
            f = hn::Add(f, hn::LoadU(d, from[5] + i));
            hn::StoreU(f, d, force + i);
        }
    }
}

template <bool windy>
HWY_INLINE void sweep(const ForceInput& input, const Part& part, const Scratch& scratch,
                      const std::function<void(const ForceRun&)>& use) {
    const Strip strip(part, input.model->grid);
    const auto springs = spring_stencils(*input.model);
    const int first_row = std::max(part.first_row - 2, 0), column = strip.at(part.first_column);
    const Rows force = scratch.force();
    for (int j = part.first_row; j < std::min(first_row + 2, strip.end_row); ++j) copy_row(input, strip, j, scratch);
    for (int j = first_row; j < strip.end_row; ++j) {
        if (j + 2 >= part.first_row && j + 2 < strip.end_row) copy_row(input, strip, j + 2, scratch);
        find_pulls<windy>(input, strip, springs, j, scratch);
        if (j < part.first_row) continue;
        add_up(strip, springs, j, scratch);
        use({strip.grid.particle(part.first_column, j),
             part.columns,
             {force[0] + column, force[1] + column, force[2] + column},
             input.model});
    }
}

void forces_on(const ForceInput& input, const Part& part, const Scratch& scratch,
               const std::function<void(const ForceRun&)>& use) {
    if (input.wind[0] != nullptr)
        sweep<true>(input, part, scratch, use);
    else
        sweep<false>(input, part, scratch, use);
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(copy_neighbours);
HWY_EXPORT(forces_on);

void copy_neighbours(const ForceInput& input, const Part& part, const Scratch& scratch) {
    HWY_DYNAMIC_DISPATCH(copy_neighbours)(input, part, scratch);
}

void forces_on(const ForceInput& input, const Part& part, const Scratch& scratch,
               const std::function<void(const ForceRun&)>& use) {
    const Grid& grid = input.model->grid;
    DRAPE_ASSERT(part.first_column >= 0 && part.columns > 0 && part.first_column + part.columns <= grid.nx);
    DRAPE_ASSERT(part.first_row >= 0 && part.rows > 0 && part.first_row + part.rows <= grid.ny);
    HWY_DYNAMIC_DISPATCH(forces_on)(input, part, scratch, use);
}

}  // namespace drape::kernels
#endif
