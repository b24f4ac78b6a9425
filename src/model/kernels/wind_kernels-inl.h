#include "model/kernels/force_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/model/forces.h"
#include "model/kernels/axes.h"

HWY_BEFORE_NAMESPACE();
namespace drape::kernels::HWY_NAMESPACE {

using Axes = std::array<const Real*, 3>;

struct Triple {
    Real x, y, z;
};

HWY_INLINE Triple at(const Axes& p, int i) { return {p[0][i], p[1][i], p[2][i]}; }
HWY_INLINE Triple minus(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// A third of the force on triangle a, b, c. With the area vector S = A n it is 1/6 C rho |u.S| (u.S) / |S|^2 S.
HWY_INLINE Triple third_of_force(const Axes& x, const Axes& v, int a, int b, int c, Triple air, Real factor) {
    const Triple ab = minus(at(x, b), at(x, a)), ac = minus(at(x, c), at(x, a));
    const Triple s{(ab.y * ac.z - ab.z * ac.y) / 2, (ab.z * ac.x - ab.x * ac.z) / 2, (ab.x * ac.y - ab.y * ac.x) / 2};
    const Triple va = at(v, a), vb = at(v, b), vc = at(v, c);
    const Triple u{air.x - (va.x + vb.x + vc.x) / 3, air.y - (va.y + vb.y + vc.y) / 3,
                   air.z - (va.z + vb.z + vc.z) / 3};
    const Real flow = u.x * s.x + u.y * s.y + u.z * s.z;
    const Real square = std::max(s.x * s.x + s.y * s.y + s.z * s.z, std::numeric_limits<Real>::min());
    const Real scale = factor * std::abs(flow) * flow / square;
    return {scale * s.x, scale * s.y, scale * s.z};
}

void add_wind_forces(const ClothModel& model, const Points& points, const Points& velocities, Points& forces) {
    const Axes x = axes(points), v = axes(velocities);
    const std::array<Real*, 3> f = axes(forces);
    const Grid grid = model.grid;
    const Triple air{model.air.velocity[0], model.air.velocity[1], model.air.velocity[2]};
    const Real factor = plate_coefficient * model.air.density / 6;
    Real first[3][run_length], second[3][run_length];
    for (int j = 0; j < grid.cell_rows(); ++j) {
        for (int start = 0; start < grid.cell_columns(); start += run_length) {
            const int count = std::min(run_length, grid.cell_columns() - start);
            const int a = grid.particle(start, j), b = a + 1, c = a + grid.nx, d = c + 1;

            // Both triangles of each cell
            for (int i = 0; i < count; ++i) {
                const Triple p = third_of_force(x, v, a + i, c + i, b + i, air, factor);
                const Triple q = third_of_force(x, v, b + i, c + i, d + i, air, factor);
                first[0][i] = p.x, first[1][i] = p.y, first[2][i] = p.z;
                second[0][i] = q.x, second[1][i] = q.y, second[2][i] = q.z;
            }

            // Corners b and c belong to both
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Real *p = first[axis], *q = second[axis];
                Real* const g = f[axis];
                for (int i = 0; i < count; ++i) g[a + i] += p[i];
                for (int i = 0; i < count; ++i) g[b + i] += p[i] + q[i];
                for (int i = 0; i < count; ++i) g[c + i] += p[i] + q[i];
                for (int i = 0; i < count; ++i) g[d + i] += q[i];
            }
        }
    }
}

}  // namespace drape::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::kernels {

HWY_EXPORT(add_wind_forces);

void add_wind_forces(const ClothModel& model, const Points& x, const Points& v, Points& f) {
    HWY_DYNAMIC_DISPATCH(add_wind_forces)(model, x, v, f);
}

}  // namespace drape::kernels
#endif
