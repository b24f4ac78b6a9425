#include "wind.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/vectorise.h"
#include "drape/model/energy.h"

namespace drape {
namespace kernels {
namespace {

/// Drag coefficient of a square plate across the flow (@cite hoerner1965, chapter 3).
constexpr Real plate_coefficient = Real(1.17);

/// Cells are evaluated in runs of this many, so that their forces fit on the stack.
constexpr int run_length = 128;

struct Triple {
    Real x, y, z;
};

DRAPE_INLINE Triple at(const Real* const p[3], int i) { return {p[0][i], p[1][i], p[2][i]}; }
DRAPE_INLINE Triple minus(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// A third of the force on triangle a, b, c. With the area vector S = A n it is 1/6 C rho |u.S| (u.S) / |S|^2 S.
DRAPE_INLINE Triple third_of_force(const Real* const x[3], const Real* const v[3], int a, int b, int c, Triple air,
                                   Real factor) {
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

}  // namespace

DRAPE_VECTORISE void wind_forces(const ClothModel& model, const Real* const x[3], const Real* const v[3],
                                 Real* const f[3]) {
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
            for (int axis = 0; axis < 3; ++axis) {
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

}  // namespace kernels

double most_wind_power(const ClothModel& model) {
    constexpr double stretched = 2;
    const auto speed = static_cast<double>(model.air.velocity.norm());
    const Grid& grid = model.grid;
    const auto area = static_cast<double>(model.hx * model.hy) * (grid.nx - 1) * (grid.ny - 1);
    const auto pressure = static_cast<double>(kernels::plate_coefficient * model.air.density) / 2;  // over W^2
    return stretched * pressure * area * speed * speed * speed * 4 / 27;
}

}  // namespace drape
