#include "near_cells.h"

#include <algorithm>
#include <limits>

#include "drape/base/vectorise.h"

namespace drape::kernels {
namespace {

/// Cells that are looked at together.
constexpr int lanes = 4;

/// For `count` cells from the one whose corner a is particle `at`: squared distance that is sure, less the squared
/// reach.
template <int count>
DRAPE_INLINE void margins(const Real* const x[3], int at, int nx, const Real p[3], Real reach, Real* margin) {
    constexpr Real rounding = 32 * std::numeric_limits<Real>::epsilon();
    const Real *ax = x[0] + at, *ay = x[1] + at, *az = x[2] + at;
    const auto square_to_p = [&](int i) {
        const Real dx = ax[i] - p[0], dy = ay[i] - p[1], dz = az[i] - p[2];
        return dx * dx + dy * dy + dz * dz;
    };
    const auto square_between = [&](int i, int k) {
        const Real dx = ax[i] - ax[k], dy = ay[i] - ay[k], dz = az[i] - az[k];
        return dx * dx + dy * dy + dz * dz;
    };
    for (int l = 0; l < count; ++l) {
        const int a = l, b = l + 1, c = l + nx, d = l + nx + 1;
        const Real nearest =
            std::min(std::min(square_to_p(a), square_to_p(b)), std::min(square_to_p(c), square_to_p(d)));
        const Real sides = std::max(std::max(square_between(a, b), square_between(a, c)),
                                    std::max(square_between(d, b), square_between(d, c)));
        const Real longest = std::max(sides, square_between(b, c));
        margin[l] = nearest * (1 - rounding) - longest * ((1 + rounding) / 3) - reach * reach;
    }
}

}  // namespace

DRAPE_VECTORISE void flag_near_cells(const Grid& grid, const Real* const x[3], const Vec3& p, Real reach,
                                     std::span<const int> cells, bool* near) {
    const Real centre[3] = {p[0], p[1], p[2]};
    const int columns = grid.cell_columns(), count = static_cast<int>(cells.size());
    const int* const cell = cells.data();
    Real margin[lanes];
    for (int k = 0; k < count;) {
        const int row = cell[k] / columns, at = cell[k] + row, row_end = (row + 1) * columns;
        int run = 1;
        while (run < lanes && k + run < count && cell[k + run] == cell[k] + run && cell[k] + run < row_end) ++run;

        // All lanes at once, unless the last ones would read beyond the last particle
        if (at + grid.nx + lanes < grid.particles()) {
            margins<lanes>(x, at, grid.nx, centre, reach, margin);
        } else {
            for (int l = 0; l < run; ++l) margins<1>(x, at + l, grid.nx, centre, reach, margin + l);
        }
        for (int l = 0; l < run; ++l) near[k + l] = !(margin[l] > 0);
        k += run;
    }
}

}  // namespace drape::kernels
