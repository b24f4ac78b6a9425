#include "drape/model/forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/assert.h"
#include "drape/base/vectorise.h"
#include "drape/model/stencils.h"
#include "wind.h"

namespace drape {
namespace kernels {

/// Springs are evaluated in runs of this many, so that their forces fit on the stack.
constexpr int run_length = 128;

/// f_a += s and f_b -= s for one run of springs and one coordinate.
DRAPE_INLINE void add_opposite(const Real* s, Real* f_a, Real* f_b, int count) {
    for (int i = 0; i < count; ++i) f_a[i] += s[i];
    for (int i = 0; i < count; ++i) f_b[i] -= s[i];
}

/// The forces of `count` springs whose first ends start at a and whose second ends start at b, both contiguous.
/// k, c, rest: spring law; x, v: positions and velocities by coordinate. A zero length is lifted to a tiny
/// one, which makes the direction, and so the force, zero.
DRAPE_INLINE void spring_run(const Real* const x[3], const Real* const v[3], int a, int b, int count, Real k, Real c,
                             Real rest, Real* const f[3]) {
    const Real tiny =
        std::sqrt(std::numeric_limits<Real>::min());  // so tiny that its inverse is still far from infinity
    Real sx[run_length], sy[run_length], sz[run_length];
    const Real *ax = x[0] + a, *ay = x[1] + a, *az = x[2] + a, *bx = x[0] + b, *by = x[1] + b, *bz = x[2] + b;
    const Real *ux = v[0] + a, *uy = v[1] + a, *uz = v[2] + a, *wx = v[0] + b, *wy = v[1] + b, *wz = v[2] + b;
    for (int i = 0; i < count; ++i) {
        const Real dx = ax[i] - bx[i], dy = ay[i] - by[i], dz = az[i] - bz[i];
        const Real length = std::sqrt(dx * dx + dy * dy + dz * dz);
        const Real inverse = 1 / std::max(length, tiny);
        const Real closing = (dx * (ux[i] - wx[i]) + dy * (uy[i] - wy[i]) + dz * (uz[i] - wz[i])) * inverse;
        const Real scale = -(k * (length - rest) + c * closing) * inverse;
        sx[i] = scale * dx;
        sy[i] = scale * dy;
        sz[i] = scale * dz;
    }
    add_opposite(sx, f[0] + a, f[0] + b, count);
    add_opposite(sy, f[1] + a, f[1] + b, count);
    add_opposite(sz, f[2] + a, f[2] + b, count);
}

DRAPE_VECTORISE void spring_forces(const SpringStencil& stencil, const Grid& grid, const Real* const x[3],
                                   const Real* const v[3], Real* const f[3]) {
    const Real k = stencil.law.stiffness, c = stencil.law.damping, rest = stencil.rest_length;
    const int count = stencil.count(grid);
    for (int j = 0; j < stencil.rows(grid); ++j) {
        const int a = grid.particle(stencil.first_column(), j);
        const int b = a + stencil.dj * grid.nx + stencil.di;
        for (int start = 0; start < count; start += run_length) {
            spring_run(x, v, a + start, b + start, std::min(run_length, count - start), k, c, rest, f);
        }
    }
}

}  // namespace kernels

void compute_forces(const ClothModel& model, const Points& x, const Points& v, Points& f) {
    const Eigen::Index n = model.grid.particles();
    DRAPE_ASSERT(x.rows() == n && v.rows() == n && f.rows() == n);

    // Gravity and drag
    for (int axis = 0; axis < 3; ++axis) {
        f.col(axis).array() = model.particle_mass * model.gravity[axis] - model.drag * v.col(axis).array();
    }

    // Springs
    const Real* const xs[3] = {x.col(0).data(), x.col(1).data(), x.col(2).data()};
    const Real* const vs[3] = {v.col(0).data(), v.col(1).data(), v.col(2).data()};
    Real* const fs[3] = {f.col(0).data(), f.col(1).data(), f.col(2).data()};
    for (const SpringStencil& stencil : spring_stencils(model)) {
        if (stencil.law == SpringLaw{} || stencil.rows(model.grid) < 1 || stencil.count(model.grid) < 1) continue;
        kernels::spring_forces(stencil, model.grid, xs, vs, fs);
    }

    if (model.air.density > 0) kernels::wind_forces(model, xs, vs, fs);
}

void forces_to_accelerations(const ClothModel& model, Points& f) {
    for (int axis = 0; axis < 3; ++axis) f.col(axis).array() *= model.inverse_mass;
}

}  // namespace drape
