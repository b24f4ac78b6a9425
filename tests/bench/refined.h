#pragma once

#include <algorithm>

#include "drape/model/cloth_model.h"

namespace drape::bench {

/// The same surface on another grid, bilinear between the particles that there are.
inline Points refined(const Grid& to, const Grid& from, const Points& x) {
    if (to == from) return x;
    Points fine(to.particles(), 3);
    for (int j = 0; j < to.ny; ++j) {
        for (int i = 0; i < to.nx; ++i) {
            const Real u = static_cast<Real>(i * (from.nx - 1)) / static_cast<Real>(to.nx - 1);
            const Real w = static_cast<Real>(j * (from.ny - 1)) / static_cast<Real>(to.ny - 1);
            const int column = std::min(static_cast<int>(u), from.nx - 2);
            const int p = from.particle(column, std::min(static_cast<int>(w), from.ny - 2));
            const Real s = u - static_cast<Real>(column), t = w - static_cast<Real>(p / from.nx);
            fine.row(to.particle(i, j)) = (1 - t) * ((1 - s) * x.row(p) + s * x.row(p + 1)) +
                                          t * ((1 - s) * x.row(p + from.nx) + s * x.row(p + from.nx + 1));
        }
    }
    return fine;
}

}  // namespace drape::bench
