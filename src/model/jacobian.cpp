#include "drape/model/jacobian.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/assert.h"
#include "drape/base/vectorise.h"
#include "drape/model/stencils.h"

namespace drape {
namespace kernels {

/// Springs are evaluated in runs of this many, so that their products fit on the stack.
constexpr int jacobian_run = 128;

/// y_a += g and y_b -= g for one run of springs and one coordinate.
DRAPE_INLINE void add_opposite(const Real* g, Real* y_a, Real* y_b, int count) {
    for (int i = 0; i < count; ++i) y_a[i] += g[i];
    for (int i = 0; i < count; ++i) y_b[i] -= g[i];
}

/// One coordinate array an axis, from the first ends and from the second ends of a run of springs.
struct RunEnds {
    const Real* a[3];
    const Real* b[3];
};

/// Legend: d, n, w, T as in the header; s = n.w; slopes: the columns of `Family::slopes`, the last three null when
/// clamped. A length that is as good as zero makes n and T/|d| zero.
DRAPE_VECTORISE void linearise_run(const RunEnds& x, const RunEnds& v, int count, const SpringStencil& stencil,
                                   Real* const slopes[7]) {
    const Real tiny = std::sqrt(std::numeric_limits<Real>::min());
    const Real k = stencil.law.stiffness, c = stencil.law.damping, rest = stencil.rest_length;
    const bool clamped = slopes[4] == nullptr;
    const Real least_tension = clamped ? Real(0) : std::numeric_limits<Real>::lowest();
    Real inverse[jacobian_run], s[jacobian_run];
    for (int i = 0; i < count; ++i) {
        const Real dx = x.a[0][i] - x.b[0][i], dy = x.a[1][i] - x.b[1][i], dz = x.a[2][i] - x.b[2][i];
        const Real length = std::sqrt(dx * dx + dy * dy + dz * dz);
        inverse[i] = length > tiny ? 1 / std::max(length, tiny) : Real(0);
        const Real nx = dx * inverse[i], ny = dy * inverse[i], nz = dz * inverse[i];
        s[i] = nx * (v.a[0][i] - v.b[0][i]) + ny * (v.a[1][i] - v.b[1][i]) + nz * (v.a[2][i] - v.b[2][i]);
        slopes[0][i] = nx;
        slopes[1][i] = ny;
        slopes[2][i] = nz;
        slopes[3][i] = std::max(k * (length - rest) + c * s[i], least_tension) * inverse[i];
    }
    if (clamped) return;
    for (int axis = 0; axis < 3; ++axis) {
        const Real *va = v.a[axis], *vb = v.b[axis], *n = slopes[axis];
        Real* const skew = slopes[4 + axis];
        for (int i = 0; i < count; ++i) skew[i] = c * inverse[i] * (va[i] - vb[i] - s[i] * n[i]);
    }
}

/// y_a += g and y_b -= g, with g the product of a spring's block and u_a - u_b.
/// along: what the block does to a vector along the spring, k_scale k + d_scale c.
template <bool clamped>
DRAPE_INLINE void product_of_run(const RunEnds& u, int count, const Real* const slopes[7], Real along, Real k_scale,
                                 Real* const y_a[3], Real* const y_b[3]) {
    Real gx[jacobian_run], gy[jacobian_run], gz[jacobian_run];
    const Real *ax = u.a[0], *ay = u.a[1], *az = u.a[2], *bx = u.b[0], *by = u.b[1], *bz = u.b[2];
    const Real *nx = slopes[0], *ny = slopes[1], *nz = slopes[2], *tension = slopes[3];
    const Real *qx = slopes[4], *qy = slopes[5], *qz = slopes[6];
    for (int i = 0; i < count; ++i) {
        const Real dx = ax[i] - bx[i], dy = ay[i] - by[i], dz = az[i] - bz[i];
        const Real across = k_scale * tension[i];
        Real inward = (along - across) * (nx[i] * dx + ny[i] * dy + nz[i] * dz);
        if constexpr (!clamped) inward += k_scale * (qx[i] * dx + qy[i] * dy + qz[i] * dz);
        gx[i] = across * dx + inward * nx[i];
        gy[i] = across * dy + inward * ny[i];
        gz[i] = across * dz + inward * nz[i];
    }
    add_opposite(gx, y_a[0], y_b[0], count);
    add_opposite(gy, y_a[1], y_b[1], count);
    add_opposite(gz, y_a[2], y_b[2], count);
}

DRAPE_VECTORISE void product_run(const RunEnds& u, int count, const Real* const slopes[7], Real along, Real k_scale,
                                 Real* const y_a[3], Real* const y_b[3]) {
    if (slopes[4] == nullptr) {
        product_of_run<true>(u, count, slopes, along, k_scale, y_a, y_b);
    } else {
        product_of_run<false>(u, count, slopes, along, k_scale, y_a, y_b);
    }
}

}  // namespace kernels

namespace {

kernels::RunEnds ends_of(const Points& points, int a, int b) {
    return {{points.col(0).data() + a, points.col(1).data() + a, points.col(2).data() + a},
            {points.col(0).data() + b, points.col(1).data() + b, points.col(2).data() + b}};
}

/// Calls run(first particle, count) for pieces of [begin, end) that fit a run.
template <class Run>
void for_each_run(int begin, int end, Run run) {
    for (int a = begin; a < end; a += kernels::jacobian_run) run(a, std::min(kernels::jacobian_run, end - a));
}

/// The columns of `Family::slopes` from row a on, null where there is none.
template <class Number, class Slopes>
std::array<Number*, 7> columns_from(Slopes& slopes, int a) {
    std::array<Number*, 7> columns{};
    for (Eigen::Index column = 0; column < slopes.cols(); ++column) {
        columns[static_cast<std::size_t>(column)] = slopes.col(column).data() + a;
    }
    return columns;
}

}  // namespace

Jacobian::Jacobian(const Grid& grid, Hessian hessian) : hessian_(hessian) {
    for (Family& family : families_) family.slopes.setZero(grid.particles(), hessian == Hessian::Exact ? 7 : 4);
}

void Jacobian::linearise(const ClothModel& model, const Points& x, const Points& v) {
    const Grid& grid = model.grid;
    DRAPE_ASSERT(families_[0].slopes.rows() == grid.particles());
    DRAPE_ASSERT(x.rows() == grid.particles() && v.rows() == grid.particles());
    drag_ = model.drag;
    const auto stencils = spring_stencils(model);
    for (std::size_t s = 0; s < stencils.size(); ++s) {
        const SpringStencil& stencil = stencils[s];
        Family& family = families_[s];
        const bool none = stencil.law == SpringLaw{};
        family.stiffness = stencil.law.stiffness;
        family.damping = stencil.law.damping;
        family.first = stencil.first_column();
        family.reach = stencil.dj * grid.nx + stencil.di;
        family.rows = none ? 0 : std::max(0, stencil.rows(grid));
        family.count = none ? 0 : std::max(0, stencil.count(grid));
        family.stride = grid.nx;
        for (int j = 0; j < family.rows; ++j) {
            const int row = family.first + j * family.stride;
            for_each_run(row, row + family.count, [&](int a, int count) {
                const int b = a + family.reach;
                kernels::linearise_run(ends_of(x, a, b), ends_of(v, a, b), count, stencil,
                                       columns_from<Real>(family.slopes, a).data());
            });
        }
    }
}

void Jacobian::add_product(Real k_scale, Real d_scale, const Points& u, Points& y) const {
    y += (d_scale * drag_) * u;
    for (const Family& family : families_) {
        if (family.rows == 0 || family.count == 0) continue;
        const Real along = k_scale * family.stiffness + d_scale * family.damping;
        const int last = family.first + (family.rows - 1) * family.stride + family.count;
        for_each_run(family.first, last, [&](int a, int count) {
            const int b = a + family.reach;
            Real* const y_a[3] = {y.col(0).data() + a, y.col(1).data() + a, y.col(2).data() + a};
            Real* const y_b[3] = {y.col(0).data() + b, y.col(1).data() + b, y.col(2).data() + b};
            kernels::product_run(ends_of(u, a, b), count, columns_from<const Real>(family.slopes, a).data(), along,
                                 k_scale, y_a, y_b);
        });
    }
}

}  // namespace drape
