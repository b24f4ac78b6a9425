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

/// Calls visit(d, i) for vectors of neighbours that cover first <= i < last. The last vector starts early enough to end
/// with them, and where they do not fill a vector, shorter ones are taken: some are visited twice.
template <class D, class Visit>
HWY_INLINE void for_each_vector(D d, int first, int last, Visit visit) {
    constexpr int lanes = static_cast<int>(hn::MaxLanes(D()));
    if (last - first < lanes) {
        if constexpr (lanes > 1) for_each_vector(hn::CappedTag<Real, lanes / 2>(), first, last, visit);
        return;
    }
    int i = first;
    for (; i + lanes <= last; i += lanes) visit(d, i);
    if (i < last) visit(d, last - lanes);
}

template <class V>
struct Triple {
    V x, y, z;
};

template <class D>
HWY_INLINE Triple<hn::Vec<D>> load(D d, const Real* const p[3], int i) {
    return {hn::LoadU(d, p[0] + i), hn::LoadU(d, p[1] + i), hn::LoadU(d, p[2] + i)};
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

/// The pull T n of springs of one kind, T = k (|d| - L0) + c n.dv with d = x_a - x_b, dv = v_a - v_b, n = d/|d|: it is
/// taken from the force on a and added to that on b. A zero length is lifted to a tiny one, whose inverse is still far
/// from infinity; it makes n, and so the pull, zero.
/// @param a, b the first of the vector's particles
template <class D>
HWY_INLINE Triple<hn::Vec<D>> pull(D d, const ForceInput& input, const SpringStencil& spring, int a, int b) {
    const auto k = hn::Set(d, spring.law.stiffness), c = hn::Set(d, spring.law.damping);
    const auto rest = hn::Set(d, spring.rest_length);
    const auto tiny = hn::Set(d, std::sqrt(std::numeric_limits<Real>::min()));
    const auto offset = minus(load(d, input.x, a), load(d, input.x, b));
    const auto length = hn::Sqrt(dot(offset, offset));
    const auto n = times(offset, hn::Div(hn::Set(d, Real(1)), hn::Max(length, tiny)));
    const auto closing = dot(n, minus(load(d, input.v, a), load(d, input.v, b)));
    return times(n, hn::Add(hn::Mul(k, hn::Sub(length, rest)), hn::Mul(c, closing)));
}

/// The pulls of one row's springs of one kind, by the column of the first end; zero where there is no spring.
struct PullRow {
    static constexpr int margin = 2;  // columns on both sides that a spring reaches
    Real pull[3][most_columns + 2 * margin];
};

/// The pulls of one kind of spring in as many rows as its springs reach over. What lies outside the cloth stays zero.
struct Pulls {
    SpringStencil spring;
    PullRow rows[3];

    PullRow& row(int j) { return rows[(j + spring.dj + 1) % (spring.dj + 1)]; }
};

/// Finds the pulls of the springs whose first ends lie in row j, as far as they hold particles of the part.
HWY_INLINE void find_pulls(const ForceInput& input, const Part& part, int j, Pulls& pulls) {
    const Grid grid = input.model->grid;
    const SpringStencil spring = pulls.spring;  // a copy, which no store can change: its numbers stay in registers
    PullRow& row = pulls.row(j);
    if (j >= spring.rows(grid)) {
        row = {};
        return;
    }
    const int first = std::max(part.first_column - std::max(spring.di, 0), spring.first_column());
    const int last = std::min(part.first_column + part.columns + std::max(-spring.di, 0),
                              spring.first_column() + spring.count(grid));
    const int reach = spring.dj * grid.nx + spring.di, column = PullRow::margin - part.first_column;
    for_each_vector(hn::ScalableTag<Real>(), first, last, [&](auto d, int i) HWY_ATTR {
        const int a = grid.particle(i, j);
        const auto found = pull(d, input, spring, a, a + reach);
        hn::StoreU(found.x, d, row.pull[0] + column + i);
        hn::StoreU(found.y, d, row.pull[1] + column + i);
        hn::StoreU(found.z, d, row.pull[2] + column + i);
    });
}

/// Adds up the forces on the particles of row j: gravity, drag, wind, and the pulls of all springs at both their ends.
template <bool windy>
HWY_INLINE void add_up(const ForceInput& input, const Part& part, int j, Pulls (&kinds)[6],
                       Real (&force)[3][most_columns]) {
    const ClothModel& model = *input.model;
    const int p = model.grid.particle(part.first_column, j);
    for (int axis = 0; axis < 3; ++axis) {
        const Real weight = model.particle_mass * model.gravity[axis], drag = model.drag;
        const Real *v = input.v[axis] + p, *wind = windy ? input.wind[axis] + p : nullptr;
        const Real *from[6], *to[6];
        for (int s = 0; s < 6; ++s) {
            const SpringStencil& spring = kinds[s].spring;
            from[s] = kinds[s].row(j).pull[axis] + PullRow::margin;
            to[s] = kinds[s].row(j - spring.dj).pull[axis] + PullRow::margin - spring.di;
        }
        for_each_vector(hn::ScalableTag<Real>(), 0, part.columns, [&](auto d, int i) HWY_ATTR {
            auto f = hn::Sub(hn::Set(d, weight), hn::Mul(hn::Set(d, drag), hn::LoadU(d, v + i)));
            if constexpr (windy) f = hn::Add(f, hn::LoadU(d, wind + i));
            f = hn::Add(hn::Sub(f, hn::LoadU(d, from[0] + i)), hn::LoadU(d, to[0] + i));
            f = hn::Add(hn::Sub(f, hn::LoadU(d, from[1] + i)), hn::LoadU(d, to[1] + i));
            f = hn::Add(hn::Sub(f, hn::LoadU(d, from[2] + i)), hn::LoadU(d, to[2] + i));
            f = hn::Add(hn::Sub(f, hn::LoadU(d, from[3] + i)), hn::LoadU(d, to[3] + i));
            f = hn::Add(hn::Sub(f, hn::LoadU(d, from[4] + i)), hn::LoadU(d, to[4] + i));
            f = hn::Add(hn::Sub(f, hn::LoadU(d, from[5] + i)), hn::LoadU(d, to[5] + i));
            hn::StoreU(f, d, force[axis] + i);
        });
    }
}

/// The pulls of a kind without a law, and of rows and columns without springs, are zero from the start.
HWY_INLINE void clear(const SpringStencil& spring, const Part& part, Pulls& pulls) {
    pulls.spring = spring;
    for (int row = 0; row <= spring.dj; ++row) {
        for (Real* axis : pulls.rows[row].pull) std::fill_n(axis, part.columns + 2 * PullRow::margin, Real(0));
    }
}

void forces_on(const ForceInput& input, const Part& part, const std::function<void(const ForceRun&)>& use) {
    HWY_ALIGN Pulls kinds[6];
    const auto springs = spring_stencils(*input.model);
    for (std::size_t s = 0; s < springs.size(); ++s) clear(springs[s], part, kinds[s]);
    HWY_ALIGN Real force[3][most_columns];
    for (int j = std::max(part.first_row - 2, 0); j < part.first_row + part.rows; ++j) {
        for (Pulls& pulls : kinds) {
            if (pulls.spring.law != SpringLaw{} && j + pulls.spring.dj >= part.first_row) {
                find_pulls(input, part, j, pulls);
            }
        }
        if (j < part.first_row) continue;
        if (input.wind[0] != nullptr)
            add_up<true>(input, part, j, kinds, force);
        else
            add_up<false>(input, part, j, kinds, force);
        use({input.model->grid.particle(part.first_column, j),
             part.columns,
             {force[0], force[1], force[2]},
             input.model});
    }
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
