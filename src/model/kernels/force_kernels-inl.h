#include "force_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/model/stencils.h"
#include "model/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE Lanes3<hn::Vec<D>> load(D d, const Rows& rows, int i) {
    return {hn::LoadU(d, rows[0] + i), hn::LoadU(d, rows[1] + i), hn::LoadU(d, rows[2] + i)};
}

template <class D>
HWY_INLINE void store(const Lanes3<hn::Vec<D>>& values, D d, const Rows& rows, int i) {
    hn::StoreU(values.x, d, rows[0] + i);
    hn::StoreU(values.y, d, rows[1] + i);
    hn::StoreU(values.z, d, rows[2] + i);
}

/// Copies some numbers, of which the last vector may reach back into the one before.
HWY_INLINE void copy(const Real* from, int count, Real* to) {
    const hn::CappedTag<Real, ForceScratch::margin> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    if (count < lanes) {
        for (int i = 0; i < count; ++i) to[i] = from[i];
        return;
    }
    for (int i = 0; i + lanes <= count; i += lanes) hn::StoreU(hn::LoadU(d, from + i), d, to + i);
    hn::StoreU(hn::LoadU(d, from + count - lanes), d, to + count - lanes);
}

/// Copies a row of particles. Rows that the cloth does not have are left at zero.
HWY_INLINE void copy_row(const ForceInput& input, int row, ForceScratch& scratch) {
    const int p = scratch.grid.particle(0, row), count = scratch.grid.nx;
    if (row >= scratch.grid.ny) return;
    const Rows x = scratch.x(row), v = scratch.v(row), wind = scratch.wind(row);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        copy(input.x[axis] + p, count, x[axis] + ForceScratch::margin);
        copy(input.v[axis] + p, count, v[axis] + ForceScratch::margin);
        if (input.wind[0] != nullptr) copy(input.wind[axis] + p, count, wind[axis] + ForceScratch::margin);
    }
}

void copy_neighbours(const ForceInput& input, ForceScratch& scratch) {
    for (int row = std::max(scratch.first_row - 2, 0); row < scratch.first_row; ++row) {
        copy_row(input, row, scratch);
    }
    for (int row = scratch.end_row; row < scratch.end_row + 2; ++row) copy_row(input, row, scratch);
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

HWY_INLINE SpringPair spring_pair(const std::array<SpringStencil, 6>& springs, int first, int j,
                                  ForceScratch& scratch) {
    SpringPair pair;
    pair.law = springs[static_cast<std::size_t>(first)].law;
    for (int s = 0; s < 2; ++s) {
        const SpringStencil& spring = springs[static_cast<std::size_t>(first + s)];
        pair.rest_length[s] = spring.rest_length;
        pair.x[s] = scratch.x(j + spring.dj);
        pair.v[s] = scratch.v(j + spring.dj);
        pair.di[s] = spring.di;
        pair.there[s] = j + spring.dj < scratch.grid.ny ? scratch.there(first + s) : scratch.zeros();
        pair.pull[s] = scratch.pulls(first + s, j);
    }
    return pair;
}

/// Finds the pull of one spring of a pair, (k - k L0/|d| + c d.dv/|d|^2) d, and takes it from the force on a.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void pull(D d, const SpringPair& pair, int s, const Lanes3<V>& offset, V one_over_length, const Lanes3<V>& v,
                     int i, Lanes3<V>& force) {
    const auto k = hn::Set(d, pair.law.stiffness), c = hn::Set(d, pair.law.damping);
    const auto closing = dot(offset, minus(v, load(d, pair.v[s], i + pair.di[s])));
    const auto rest = hn::Set(d, pair.law.stiffness * pair.rest_length[s]);
    const auto damping = hn::Mul(hn::Mul(hn::Mul(c, closing), one_over_length), one_over_length);
    const auto factor = hn::Add(hn::Sub(k, hn::Mul(rest, one_over_length)), damping);
    const auto found = times(offset, hn::Mul(factor, hn::LoadU(d, pair.there[s] + i)));
    store(found, d, pair.pull[s], i);
    force = minus(force, found);
}

/// Both springs, with d = x_a - x_b. One division serves both lengths. A zero length is lifted to a tiny one, of which
/// even the product with another has a finite inverse; the pull is zero, as d is.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void pull(D d, const SpringPair& pair, const Lanes3<V>& x, const Lanes3<V>& v, int i, Lanes3<V>& force) {
    const auto tiny = hn::Set(d, std::sqrt(std::numeric_limits<Real>::min()));
    const auto d0 = minus(x, load(d, pair.x[0], i + pair.di[0])), d1 = minus(x, load(d, pair.x[1], i + pair.di[1]));
    const auto length0 = hn::Max(hn::Sqrt(dot(d0, d0)), tiny), length1 = hn::Max(hn::Sqrt(dot(d1, d1)), tiny);
    const auto inverse = hn::Div(hn::Set(d, Real(1)), hn::Mul(length0, length1));
    pull(d, pair, 0, d0, hn::Mul(inverse, length1), v, i, force);
    pull(d, pair, 1, d1, hn::Mul(inverse, length0), v, i, force);
}

/// Finds the pulls of all springs whose first ends lie in row j, and adds them up there, with gravity, drag and wind.
HWY_INLINE void find_pulls(const ForceInput& input, const std::array<SpringStencil, 6>& springs, int j,
                           ForceScratch& scratch) {
    const hn::CappedTag<Real, ForceScratch::margin> d;
    const SpringPair structural = spring_pair(springs, 0, j, scratch);
    const SpringPair shear = spring_pair(springs, 2, j, scratch);
    const SpringPair bend = spring_pair(springs, 4, j, scratch);
    const bool windy = input.wind[0] != nullptr;
    const bool has[3] = {structural.law != SpringLaw{}, shear.law != SpringLaw{}, bend.law != SpringLaw{}};
    const Rows row_x = scratch.x(j), row_v = scratch.v(j), wind = scratch.wind(j), force = scratch.force();
    const Vec3 weight = input.model->particle_mass * input.model->gravity;
    const Real drag = input.model->drag;
    const int end = ForceScratch::margin + scratch.grid.nx;
    for (int i = ForceScratch::margin; i < end; i += static_cast<int>(hn::Lanes(d))) {
        const auto x = load(d, row_x, i), v = load(d, row_v, i);
        Lanes3<hn::Vec<decltype(d)>> f{hn::Set(d, weight[0]), hn::Set(d, weight[1]), hn::Set(d, weight[2])};
        f = minus(f, times(v, hn::Set(d, drag)));
        if (windy) f = plus(f, load(d, wind, i));
        if (has[0]) pull(d, structural, x, v, i, f);
        if (has[1]) pull(d, shear, x, v, i, f);
        if (has[2]) pull(d, bend, x, v, i, f);
        store(f, d, force, i);
    }
}

/// Adds the pulls at the second ends of the springs that end in row j. No pulls were found of springs without a law,
/// nor of those from before the first row.
HWY_INLINE void add_up(const std::array<SpringStencil, 6>& springs, int j, ForceScratch& scratch) {
    const hn::CappedTag<Real, ForceScratch::margin> d;
    const int end = ForceScratch::margin + scratch.grid.nx;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real* from[6];
        for (int s = 0; s < 6; ++s) {
            const SpringStencil& spring = springs[static_cast<std::size_t>(s)];
            const bool found = spring.law != SpringLaw{} && j >= spring.dj;
            from[s] = (found ? scratch.pulls(s, j - spring.dj)[axis] : scratch.zeros()) - spring.di;
        }
        Real* const force = scratch.force()[axis];
        for (int i = ForceScratch::margin; i < end; i += static_cast<int>(hn::Lanes(d))) {
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

void forces_on(const ForceInput& input, ForceScratch& scratch, const std::function<void(const ForceRun&)>& use) {
    const auto springs = spring_stencils(*input.model);
    const int first = scratch.first_row, end = scratch.end_row, found_from = std::max(first - 2, 0);
    for (int j = first; j < std::min(found_from + 2, end); ++j) copy_row(input, j, scratch);
    for (int j = found_from; j < end; ++j) {
        if (j + 2 >= first && j + 2 < end) copy_row(input, j + 2, scratch);
        find_pulls(input, springs, j, scratch);
        if (j < first) continue;
        add_up(springs, j, scratch);
        use({scratch.grid.particle(0, j), scratch.grid.nx, scratch.force()[0] + ForceScratch::margin, scratch.length,
             input.model});
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(copy_neighbours);
HWY_EXPORT(forces_on);

ForceScratch::ForceScratch(const Grid& cloth, int first, int end) : grid(cloth), first_row(first), end_row(end) {
    // An odd number of lines, lest the rows lie apart by a power of two
    const int lines = (grid.nx + 2 * margin + CacheLine::numbers - 1) / CacheLine::numbers | 1;
    length = lines * CacheLine::numbers;
    memory_.resize(static_cast<std::size_t>(rows * lines));  // zeros
    for (std::size_t kind = 0; kind < spring_directions.size(); ++kind) {
        const int di = spring_directions[kind].di, from = std::max(0, -di), to = std::min(grid.nx, grid.nx - di);
        std::fill_n(there(static_cast<int>(kind)) + margin + from, to - from, Real(1));
    }
}

void copy_neighbours(const ForceInput& input, ForceScratch& scratch) {
    HWY_DYNAMIC_DISPATCH(copy_neighbours)(input, scratch);
}

void forces_on(const ForceInput& input, ForceScratch& scratch, const std::function<void(const ForceRun&)>& use) {
    HWY_DYNAMIC_DISPATCH(forces_on)(input, scratch, use);
}

}  // namespace drape::kernels
#endif
