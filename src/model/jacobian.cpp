#include "drape/model/jacobian.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/assert.h"
#include "drape/base/vectorise.h"
#include "stencils.h"

namespace drape {
namespace kernels {

/// Springs are evaluated in runs of this many, so that their products fit on the stack.
constexpr int jacobian_run = 128;

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
DRAPE_VECTORISE void product_run(const RunEnds& u, int count, const Real* const slopes[7], Real along, Real k_scale,
                                 Real* const y_a[3], Real* const y_b[3]) {
    Real g[3][jacobian_run], turned[jacobian_run];
    const Real *nx = slopes[0], *ny = slopes[1], *nz = slopes[2];
    const Real *qx = slopes[4], *qy = slopes[5], *qz = slopes[6];
    for (int axis = 0; axis < 3; ++axis) {
        const Real *ua = u.a[axis], *ub = u.b[axis];
        for (int i = 0; i < count; ++i) g[axis][i] = ua[i] - ub[i];
    }
    if (qx == nullptr) {
        for (int i = 0; i < count; ++i) turned[i] = 0;
    } else {
        for (int i = 0; i < count; ++i) turned[i] = k_scale * (qx[i] * g[0][i] + qy[i] * g[1][i] + qz[i] * g[2][i]);
    }
    for (int i = 0; i < count; ++i) {
        const Real across = k_scale * slopes[3][i];
        const Real inward = (along - across) * (nx[i] * g[0][i] + ny[i] * g[1][i] + nz[i] * g[2][i]) + turned[i];
        g[0][i] = across * g[0][i] + inward * nx[i];
        g[1][i] = across * g[1][i] + inward * ny[i];
        g[2][i] = across * g[2][i] + inward * nz[i];
    }
    for (int axis = 0; axis < 3; ++axis) {
        Real *ya = y_a[axis], *yb = y_b[axis];
        for (int i = 0; i < count; ++i) ya[i] += g[axis][i];
        for (int i = 0; i < count; ++i) yb[i] -= g[axis][i];
    }
}

}  // namespace kernels

namespace {

kernels::RunEnds ends_of(const Points& points, int a, int b) {
    return {{points.col(0).data() + a, points.col(1).data() + a, points.col(2).data() + a},
            {points.col(0).data() + b, points.col(1).data() + b, points.col(2).data() + b}};
}

/// Calls run(first particle, count) for pieces of a family's rows that fit a run.
template <class Family, class Run>
void for_each_run(const Family& family, Run run) {
    for (int j = 0; j < family.rows; ++j) {
        const int row = family.first + j * family.stride;
        for (int start = 0; start < family.count; start += kernels::jacobian_run) {
            run(row + start, std::min(kernels::jacobian_run, family.count - start));
        }
    }
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
    for (Family& family : families_) family.slopes.resize(grid.particles(), hessian == Hessian::Exact ? 7 : 4);
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
        family.rows = none ? 0 : stencil.rows(grid);
        family.count = none ? 0 : stencil.count(grid);
        family.stride = grid.nx;
        for_each_run(family, [&](int a, int count) {
            const int b = a + family.reach;
            kernels::linearise_run(ends_of(x, a, b), ends_of(v, a, b), count, stencil,
                                   columns_from<Real>(family.slopes, a).data());
        });
    }
}

void Jacobian::add_product(Real k_scale, Real d_scale, const Points& u, Points& y) const {
    y += (d_scale * drag_) * u;
    for (const Family& family : families_) {
        const Real along = k_scale * family.stiffness + d_scale * family.damping;
        for_each_run(family, [&](int a, int count) {
            const int b = a + family.reach;
            Real* const y_a[3] = {y.col(0).data() + a, y.col(1).data() + a, y.col(2).data() + a};
            Real* const y_b[3] = {y.col(0).data() + b, y.col(1).data() + b, y.col(2).data() + b};
            kernels::product_run(ends_of(u, a, b), count, columns_from<const Real>(family.slopes, a).data(), along,
                                 k_scale, y_a, y_b);
        });
    }
}

}  // namespace drape
