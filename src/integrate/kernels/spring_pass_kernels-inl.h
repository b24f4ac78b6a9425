#include "integrate/kernels/spring_pass_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/kernels/axes.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

/// What a spring's correction depends on, besides positions: h^2 k, h c and the rest length.
struct StepLaw {
    Real stiffness, damping, rest;
};

/// One coordinate's end of a correction.
template <int stride>
HWY_INLINE void move_ends(const Real* s, const Real* w_a, const Real* w_b, Real* x_a, Real* x_b, int count) {
    for (int i = 0; i < count; ++i) x_a[i * stride] += w_a[i * stride] * s[i];
    for (int i = 0; i < count; ++i) x_b[i * stride] -= w_b[i * stride] * s[i];
}

/// Corrects `count` springs that share no particle: first ends at a, a + stride, ..., second ends as many from b.
/// x, start: positions now and at the start of the step, by coordinate; w: weights; q: multipliers at first ends.
template <int stride>
HWY_INLINE void correct_run(const StepLaw& law, int a, int b, int count, const std::array<const Real*, 3>& start,
                            const Real* w, Real* q, const std::array<Real*, 3>& x) {
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

template <int stride>
HWY_INLINE void correct_rows(const StepSprings& step, const Grid& grid, const Points& start, Points& x) {
    const SpringStencil& springs = step.springs;
    const StepLaw law{step.h * step.h * springs.law.stiffness, step.h * springs.law.damping, springs.rest_length};
    const int count = springs.count(grid), offset = springs.offset(grid);
    for (int j = 0; j < springs.rows(grid); ++j) {
        const int a = grid.particle(springs.first_column(), j);
        for (int first = 0; first < stride; ++first) {
            for (int i = first; i < count; i += stride * run_length) {
                const int length = std::min(run_length, (count - i + stride - 1) / stride);
                correct_run<stride>(law, a + i, a + i + offset, length, axes(start), step.weights, step.multipliers,
                                    axes(x));
            }
        }
    }
}

void correct_springs(const StepSprings& step, const Grid& grid, const Points& start, Points& x) {
    if (step.stride() == 1) return correct_rows<1>(step, grid, start, x);
    if (step.stride() == 2) return correct_rows<2>(step, grid, start, x);
    correct_rows<4>(step, grid, start, x);
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(correct_springs);

void correct_springs(const StepSprings& step, const Grid& grid, const Points& start, Points& x) {
    HWY_DYNAMIC_DISPATCH(correct_springs)(step, grid, start, x);
}

}  // namespace drape::kernels
#endif
