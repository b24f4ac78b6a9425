#include "force_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/force_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/model/stencils.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Columns before and after those that are looked at: springs and the last vector reach into them.
constexpr int margin = 16;
using Row = Real[looked_at + 2 * margin];

template <class V>
struct Triple {
    V x, y, z;
};

template <class D>
HWY_INLINE Triple<hn::Vec<D>> load(D d, const Row* rows, int i) {
    return {hn::LoadU(d, rows[0] + i), hn::LoadU(d, rows[1] + i), hn::LoadU(d, rows[2] + i)};
}

template <class D>
HWY_INLINE void store(const Triple<hn::Vec<D>>& values, D d, Row* rows, int i) {
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

/// A row of particles, copied: rows of the cloth may lie apart by a power of two and then drive each other out of the
/// cache. Columns and rows that the cloth does not have are zero.
struct Particles {
    Row x[3], v[3], wind[3];
};

/// The pulls of one row's springs of one kind, by the column of the first end; zero where there is no spring.
struct Pulls {
    Row pull[3];
};

/// What a sweep keeps while it goes from row to row.
struct Scratch {
    Particles particles[3];  // row j at j mod 3
    Pulls pulls[6][3];       // of each kind, likewise
    Row own[3];              // the forces on row j without the pulls at the springs' second ends
    Row there[6];  // of each kind, by the column of the first end: 1 if the cloth holds the second one, else 0
    Row nowhere;   // zero
    Row force[3];

    Particles& row(int j) { return particles[j % 3]; }
};

/// How a strip of a part lies in the scratch rows.
struct Strip {
    int first, last;  // columns looked at: those of the part, and those with springs that end there
    int end;          // after the last column that springs from there reach
    [[nodiscard]] int at(int column) const { return column - first + margin; }
};

HWY_INLINE Strip strip_of(const Part& part, const Grid& grid) {
    const int last = part.first_column + part.columns;
    return {std::max(part.first_column - 2, 0), std::min(last + 1, grid.nx), std::min(last + 2, grid.nx)};
}

template <bool windy>
HWY_INLINE void copy_row(const ForceInput& input, const Strip& strip, int j, Scratch& scratch) {
    const Grid grid = input.model->grid;
    Particles& row = scratch.row(j);
    if (j >= grid.ny) {
        row = {};
        return;
    }
    const int p = grid.particle(strip.first, j), count = strip.end - strip.first;
    for (int axis = 0; axis < 3; ++axis) {
        std::copy_n(input.x[axis] + p, count, row.x[axis] + margin);
        std::copy_n(input.v[axis] + p, count, row.v[axis] + margin);
        if constexpr (windy) std::copy_n(input.wind[axis] + p, count, row.wind[axis] + margin);
    }
}

/// Two kinds of spring of one law, from the same first ends.
struct SpringPair {
    SpringLaw law;
    Real rest_length[2];
    const Row *x[2], *v[2];  // of the row of the second ends
    int di[2];
    const Real* there[2];
    Row* pull[2];
};

HWY_INLINE SpringPair spring_pair(const std::array<SpringStencil, 6>& springs, int first, const Grid& grid, int j,
                                  Scratch& scratch) {
    SpringPair pair;
    pair.law = springs[static_cast<std::size_t>(first)].law;
    for (int s = 0; s < 2; ++s) {
        const SpringStencil& spring = springs[static_cast<std::size_t>(first + s)];
        pair.rest_length[s] = spring.rest_length;
        pair.x[s] = scratch.row(j + spring.dj).x;
        pair.v[s] = scratch.row(j + spring.dj).v;
        pair.di[s] = spring.di;
        pair.there[s] = j + spring.dj < grid.ny ? scratch.there[first + s] : scratch.nowhere;
        pair.pull[s] = scratch.pulls[first + s][j % 3].pull;
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
                           int j, Scratch& scratch) {
    const hn::CappedTag<Real, margin> d;
    const ClothModel& model = *input.model;
    const SpringPair structural = spring_pair(springs, 0, model.grid, j, scratch);
    const SpringPair shear = spring_pair(springs, 2, model.grid, j, scratch);
    const SpringPair bend = spring_pair(springs, 4, model.grid, j, scratch);
    const bool has[3] = {structural.law != SpringLaw{}, shear.law != SpringLaw{}, bend.law != SpringLaw{}};
    const Particles& row = scratch.row(j);
    const Vec3 weight = model.particle_mass * model.gravity;
    const Real drag = model.drag;
    const int end = strip.at(strip.last);
    for (int i = margin; i < end; i += static_cast<int>(hn::Lanes(d))) {
        const auto x = load(d, row.x, i), v = load(d, row.v, i);
        Triple<hn::Vec<decltype(d)>> f{hn::Set(d, weight[0]), hn::Set(d, weight[1]), hn::Set(d, weight[2])};
        f = minus(f, times(v, hn::Set(d, drag)));
        if constexpr (windy) f = plus(f, load(d, row.wind, i));
        if (has[0]) pull(d, structural, x, v, i, f);
        if (has[1]) pull(d, shear, x, v, i, f);
        if (has[2]) pull(d, bend, x, v, i, f);
        store(f, d, scratch.own, i);
    }
}

/// Adds the pulls at the second ends of the springs that end in row j.
HWY_INLINE void add_up(const Part& part, const Strip& strip, const std::array<SpringStencil, 6>& springs, int j,
                       Scratch& scratch) {
    const hn::CappedTag<Real, margin> d;
    const int first = strip.at(part.first_column);
    for (int axis = 0; axis < 3; ++axis) {
        const Real* from[6];
        for (int s = 0; s < 6; ++s) {
            const SpringStencil& spring = springs[static_cast<std::size_t>(s)];
            from[s] = scratch.pulls[s][(j - spring.dj + 3) % 3].pull[axis] + first - spring.di;
        }
        const Real* own = scratch.own[axis] + first;
        for (int i = 0; i < part.columns; i += static_cast<int>(hn::Lanes(d))) {
            auto f = hn::LoadU(d, own + i);
            f = hn::Add(f, hn::LoadU(d, from[0] + i));
            f = hn::Add(f, hn::LoadU(d, from[1] + i));
            f = hn::Add(f, hn::LoadU(d, from[2] + i));
            f = hn::Add(f, hn::LoadU(d, from[3] + i));
            f = hn::Add(f, hn::LoadU(d, from[4] + i));
            f = hn::Add(f, hn::LoadU(d, from[5] + i));
            hn::Store(f, d, scratch.force[axis] + i);
        }
    }
}

template <bool windy>
HWY_INLINE void sweep(const ForceInput& input, const Part& part, const std::function<void(const ForceRun&)>& use) {
    HWY_ALIGN Scratch scratch = {};
    const Grid grid = input.model->grid;
    const auto springs = spring_stencils(*input.model);
    const Strip strip = strip_of(part, grid);
    for (int s = 0; s < 6; ++s) {
        const int di = springs[static_cast<std::size_t>(s)].di;
        for (int i = strip.first; i < strip.end; ++i) {
            scratch.there[s][strip.at(i)] = i + di >= 0 && i + di < grid.nx ? Real(1) : Real(0);
        }
    }
    const int first_row = std::max(part.first_row - 2, 0);
    copy_row<windy>(input, strip, first_row, scratch);
    copy_row<windy>(input, strip, first_row + 1, scratch);
    for (int j = first_row; j < part.first_row + part.rows; ++j) {
        copy_row<windy>(input, strip, j + 2, scratch);
        find_pulls<windy>(input, strip, springs, j, scratch);
        if (j < part.first_row) continue;
        add_up(part, strip, springs, j, scratch);
        use({grid.particle(part.first_column, j),
             part.columns,
             {scratch.force[0], scratch.force[1], scratch.force[2]},
             input.model});
    }
}

void forces_on(const ForceInput& input, const Part& part, const std::function<void(const ForceRun&)>& use) {
    if (input.wind[0] != nullptr)
        sweep<true>(input, part, use);
    else
        sweep<false>(input, part, use);
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(forces_on);

void forces_on(const ForceInput& input, const Part& part, const std::function<void(const ForceRun&)>& use) {
    HWY_DYNAMIC_DISPATCH(forces_on)(input, part, use);
}

}  // namespace drape::kernels
#endif
