#include "resampled.h"

#include <algorithm>
#include <utility>

namespace drape {

Points resampled(const Points& x, const Grid& from, const Grid& to) {
    if (from == to) return x;
    Points places(to.particles(), 3);
    const auto place = [](int k, int count, int cells) {
        const Real along = static_cast<Real>(k) * static_cast<Real>(cells) / static_cast<Real>(count - 1);
        const int cell = std::min(static_cast<int>(along), cells - 1);
        return std::pair(cell, along - static_cast<Real>(cell));
    };
    for (int j = 0; j < to.ny; ++j) {
        const auto [row, v] = place(j, to.ny, from.cell_rows());
        for (int i = 0; i < to.nx; ++i) {
            const auto [column, u] = place(i, to.nx, from.cell_columns());
            const int a = from.particle(column, row), c = from.particle(column, row + 1);
            places.row(to.particle(i, j)) =
                (1 - v) * ((1 - u) * x.row(a) + u * x.row(a + 1)) + v * ((1 - u) * x.row(c) + u * x.row(c + 1));
        }
    }
    return places;
}

}  // namespace drape
