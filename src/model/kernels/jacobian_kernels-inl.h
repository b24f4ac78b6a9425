#include "model/kernels/jacobian_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/kernels/axes.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// The ends of a run of springs in an array, by coordinate: first ends from a on, second ends from b on.
struct RunEnds {
    const Real *ax, *ay, *az, *bx, *by, *bz;
};

HWY_INLINE RunEnds ends_of(const std::array<const Real*, 3>& p, int a, int b) {
    return {p[0] + a, p[1] + a, p[2] + a, p[0] + b, p[1] + b, p[2] + b};
}

/// The columns of the terms from row a on, null where there is none.
template <class Number, class Terms>
HWY_INLINE std::array<Number*, 7> columns_of(Terms& terms, int a) {
    std::array<Number*, 7> columns{};
    for (Eigen::Index column = 0; column < terms.cols(); ++column) {
        columns[static_cast<std::size_t>(column)] = terms.col(column).data() + a;
    }
    return columns;
}

/// Legend: d, n, w, T as in the Jacobian; s = n.w.
HWY_INLINE void linearise_run(const SpringStencil& springs, const RunEnds& x, const RunEnds& v, int count,
                              const std::array<Real*, 7>& terms) {
    const Real tiny = std::sqrt(std::numeric_limits<Real>::min());
    const Real k = springs.law.stiffness, c = springs.law.damping, rest = springs.rest_length;
    const auto [n0, n1, n2, tension, skew0, skew1, skew2] = terms;
    const bool clamped = skew0 == nullptr;
    const Real least_tension = clamped ? Real(0) : std::numeric_limits<Real>::lowest();
    Real inverse[run_length], s[run_length];
    for (int i = 0; i < count; ++i) {
        const Real dx = x.ax[i] - x.bx[i], dy = x.ay[i] - x.by[i], dz = x.az[i] - x.bz[i];
        const Real length = std::sqrt(dx * dx + dy * dy + dz * dz);
        inverse[i] = length > tiny ? 1 / std::max(length, tiny) : Real(0);
        const Real nx = dx * inverse[i], ny = dy * inverse[i], nz = dz * inverse[i];
        s[i] = nx * (v.ax[i] - v.bx[i]) + ny * (v.ay[i] - v.by[i]) + nz * (v.az[i] - v.bz[i]);
        n0[i] = nx;
        n1[i] = ny;
        n2[i] = nz;
        tension[i] = std::max(k * (length - rest) + c * s[i], least_tension) * inverse[i];
    }
    if (clamped) return;
    for (int i = 0; i < count; ++i) skew0[i] = c * inverse[i] * (v.ax[i] - v.bx[i] - s[i] * n0[i]);
    for (int i = 0; i < count; ++i) skew1[i] = c * inverse[i] * (v.ay[i] - v.by[i] - s[i] * n1[i]);
    for (int i = 0; i < count; ++i) skew2[i] = c * inverse[i] * (v.az[i] - v.bz[i] - s[i] * n2[i]);
}

void linearise(const SpringRows& rows, const Points& x, const Points& v, SpringTerms& terms) {
    const auto& [springs, grid, from, beyond] = rows;
    for (int j = from; j < std::min(beyond, springs.rows(grid)); ++j) {
        const int first = grid.particle(springs.first_column(), j), end = first + springs.count(grid);
        for (int a = first; a < end; a += run_length) {
            const int b = a + springs.offset(grid);
            linearise_run(springs, ends_of(axes(x), a, b), ends_of(axes(v), a, b), std::min(run_length, end - a),
                          columns_of<Real>(terms, a));
        }
    }
}

/// y_a += g and y_b -= g for one run of springs and one coordinate.
HWY_INLINE void add_opposite(const Real* g, Real* y_a, Real* y_b, int count) {
    for (int i = 0; i < count; ++i) y_a[i] += g[i];
    for (int i = 0; i < count; ++i) y_b[i] -= g[i];
}

/// y_a += g and y_b -= g, with g the product of a spring's block and u_a - u_b.
template <bool clamped>
HWY_INLINE void add_product_of_run(const RunEnds& u, int count, const std::array<const Real*, 7>& terms, Real along,
                                   Real k_scale, const std::array<Real*, 3>& y, int a, int b) {
    Real gx[run_length], gy[run_length], gz[run_length];
    const auto [ax, ay, az, bx, by, bz] = u;
    const auto [nx, ny, nz, tension, qx, qy, qz] = terms;
    for (int i = 0; i < count; ++i) {
        const Real dx = ax[i] - bx[i], dy = ay[i] - by[i], dz = az[i] - bz[i];
        const Real across = k_scale * tension[i];
        Real inward = (along - across) * (nx[i] * dx + ny[i] * dy + nz[i] * dz);
        if constexpr (!clamped) inward += k_scale * (qx[i] * dx + qy[i] * dy + qz[i] * dz);
        gx[i] = across * dx + inward * nx[i];
        gy[i] = across * dy + inward * ny[i];
        gz[i] = across * dz + inward * nz[i];
    }
    add_opposite(gx, y[0] + a, y[0] + b, count);
    add_opposite(gy, y[1] + a, y[1] + b, count);
    add_opposite(gz, y[2] + a, y[2] + b, count);
}

void add_product(const SpringRows& rows, const SpringTerms& terms, Real along, Real k_scale, const Points& u,
                 Points& y) {
    const auto& [springs, grid, from, beyond] = rows;
    const int count = springs.count(grid), last_row = std::min(beyond, springs.rows(grid)) - 1;
    if (last_row < from || count < 1) return;
    const int first = grid.particle(springs.first_column(), from);
    const int end = grid.particle(springs.first_column(), last_row) + count;
    for (int a = first; a < end; a += run_length) {
        const int b = a + springs.offset(grid), length = std::min(run_length, end - a);
        const RunEnds ends = ends_of(axes(u), a, b);
        const auto columns = columns_of<const Real>(terms, a);
        if (terms.cols() == 4)
            add_product_of_run<true>(ends, length, columns, along, k_scale, axes(y), a, b);
        else
            add_product_of_run<false>(ends, length, columns, along, k_scale, axes(y), a, b);
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(linearise);
HWY_EXPORT(add_product);

void linearise(const SpringRows& rows, const Points& x, const Points& v, SpringTerms& terms) {
    HWY_DYNAMIC_DISPATCH(linearise)(rows, x, v, terms);
}

void add_product(const SpringRows& rows, const SpringTerms& terms, Real along, Real k_scale, const Points& u,
                 Points& y) {
    HWY_DYNAMIC_DISPATCH(add_product)(rows, terms, along, k_scale, u, y);
}

}  // namespace drape::kernels
#endif
