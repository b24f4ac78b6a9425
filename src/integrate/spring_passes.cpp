#include "spring_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/assert.h"
#include "drape/base/vectorise.h"
#include "inertial_guess.h"

namespace drape {
namespace kernels {

/// Springs are corrected in runs of this many, so that their corrections fit on the stack.
constexpr int run_length = 128;

/// What a spring's correction depends on, besides positions: h^2 k, h c and the rest length.
struct StepLaw {
    Real stiffness, damping, rest;
};

/// One coordinate's end of a correction.
template <int stride>
DRAPE_INLINE void move_ends(const Real* s, const Real* w_a, const Real* w_b, Real* x_a, Real* x_b, int count) {
    for (int i = 0; i < count; ++i) x_a[i * stride] += w_a[i * stride] * s[i];
    for (int i = 0; i < count; ++i) x_b[i * stride] -= w_b[i * stride] * s[i];
}

/// Corrects `count` springs that share no particle: first ends at a, a + stride, ..., second ends as many from b.
/// x, start: positions now and at the start of the step, by coordinate; w: weights; q: multipliers at first ends.
template <int stride>
DRAPE_INLINE void correct_run(const StepLaw law, int a, int b, int count, const Real* const start[3], const Real* w,
                              Real* q, Real* const x[3]) {
    const Real tiny = std::sqrt(std::numeric_limits<Real>::min());  // its inverse is still far from infinity
    Real dq[run_length], sx[run_length], sy[run_length], sz[run_length];
    const Real *ax = x[0] + a, *ay = x[1] + a, *az = x[2] + a, *bx = x[0] + b, *by = x[1] + b, *bz = x[2] + b;
    const Real *ux = start[0] + a, *uy = start[1] + a, *uz = start[2] + a;
    const Real *wx = start[0] + b, *wy = start[1] + b, *wz = start[2] + b;
    for (int i = 0; i < count; ++i) {
        const int e = i * stride;
        const Real dx = ax[e] - bx[e], dy = ay[e] - by[e], dz = az[e] - bz[e];
        const Real mx = dx - (ux[e] - wx[e]), my = dy - (uy[e] - wy[e]), mz = dz - (uz[e] - wz[e]);
        const Real length = std::sqrt(dx * dx + dy * dy + dz * dz);
        const Real inverse = 1 / std::max(length, tiny);
        const Real apart = (dx * mx + dy * my + dz * mz) * inverse;
        const Real wanted = -(law.stiffness * (length - law.rest) + law.damping * apart + q[a + e]);
        const Real step = wanted / ((law.stiffness + law.damping) * (w[a + e] + w[b + e]) + 1);
        dq[i] = length > tiny ? step : Real(0);
        const Real scale = dq[i] * inverse;
        sx[i] = scale * dx;
        sy[i] = scale * dy;
        sz[i] = scale * dz;
    }
    for (int i = 0; i < count; ++i) q[a + i * stride] += dq[i];
    move_ends<stride>(sx, w + a, w + b, x[0] + a, x[0] + b, count);
    move_ends<stride>(sy, w + a, w + b, x[1] + a, x[1] + b, count);
    move_ends<stride>(sz, w + a, w + b, x[2] + a, x[2] + b, count);
}

/// Corrects one row of springs, of which every `stride`-th shares no particle with the one before.
template <int stride>
DRAPE_INLINE void correct_row(const StepLaw law, int a, int b, int count, const Real* const start[3], const Real* w,
                              Real* q, Real* const x[3]) {
    for (int first = 0; first < stride; ++first) {
        for (int i = first; i < count; i += stride * run_length) {
            const int left = (count - i + stride - 1) / stride;
            correct_run<stride>(law, a + i, b + i, std::min(run_length, left), start, w, q, x);
        }
    }
}

DRAPE_VECTORISE void correct_springs(const SpringStencil& springs, const StepLaw law, const Grid& grid,
                                     const Real* const start[3], const Real* w, Real* q, Real* const x[3]) {
    const int count = springs.count(grid);
    for (int j = 0; j < springs.rows(grid); ++j) {
        const int a = grid.particle(springs.first_column(), j);
        const int b = a + springs.dj * grid.nx + springs.di;
        if (springs.dj > 0) {
            correct_row<1>(law, a, b, count, start, w, q, x);
        } else if (springs.di == 1) {
            correct_row<2>(law, a, b, count, start, w, q, x);
        } else {
            correct_row<4>(law, a, b, count, start, w, q, x);
        }
    }
}

}  // namespace kernels

SpringPasses::SpringPasses(const Grid& grid)
    : grid_(grid), weights_(grid.particles()), multipliers_(grid.particles(), 6) {}

void SpringPasses::begin(const ClothModel& model, Real h) {
    h_ = h;
    weights_ = model.inverse_mass * (model.particle_mass / inertia(model, h));
    multipliers_.setZero();
}

void SpringPasses::pass(const std::array<SpringStencil, 6>& springs, const Points& start, Points& x) {
    DRAPE_ASSERT(start.rows() == grid_.particles() && x.rows() == grid_.particles());
    const Real* const starts[3] = {start.col(0).data(), start.col(1).data(), start.col(2).data()};
    Real* const xs[3] = {x.col(0).data(), x.col(1).data(), x.col(2).data()};
    for (std::size_t direction = 0; direction < springs.size(); ++direction) {
        const SpringStencil& stencil = springs[direction];
        if (stencil.law == SpringLaw{} || stencil.rows(grid_) < 1 || stencil.count(grid_) < 1) continue;
        const kernels::StepLaw law{h_ * h_ * stencil.law.stiffness, h_ * stencil.law.damping, stencil.rest_length};
        Real* const q = multipliers_.col(static_cast<Eigen::Index>(direction)).data();
        kernels::correct_springs(stencil, law, grid_, starts, weights_.data(), q, xs);
    }
}

}  // namespace drape
