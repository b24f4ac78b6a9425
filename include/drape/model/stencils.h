#pragma once

#include <array>
#include <cmath>

#include "drape/model/cloth_model.h"

namespace drape {

/// All springs of one direction: each joins particle (i, j) with (i + di, j + dj).
struct SpringStencil {
    int di, dj;
    SpringLaw law;
    Real rest_length;

    /// The rows that hold a first end, the first such column, and how many springs a row has.
    [[nodiscard]] int rows(const Grid& grid) const { return grid.ny - dj; }
    [[nodiscard]] int first_column() const { return di < 0 ? -di : 0; }
    [[nodiscard]] int count(const Grid& grid) const { return grid.nx - (di < 0 ? -di : di); }
};

/// The six directions of a cloth's springs: structural, shear, bend, two each.
inline std::array<SpringStencil, 6> spring_stencils(const ClothModel& model) {
    const Real hx = model.hx, hy = model.hy, diagonal = std::sqrt(hx * hx + hy * hy);
    return {{{1, 0, model.structural, hx},
             {0, 1, model.structural, hy},
             {1, 1, model.shear, diagonal},
             {-1, 1, model.shear, diagonal},
             {2, 0, model.bend, 2 * hx},
             {0, 2, model.bend, 2 * hy}}};
}

}  // namespace drape
