#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "drape/model/cloth_model.h"

namespace drape {

/// All springs of one direction: each joins particle (i, j) with (i + di, j + dj).
struct SpringStencil {
    int di, dj;
    SpringLaw law;
    Real rest_length;

    /// Between neighbours.
    [[nodiscard]] bool structural() const { return di + dj == 1 && di * dj == 0; }

    /// "structural", "shear" or "bend".
    [[nodiscard]] std::string_view kind() const {
        return structural() ? "structural" : di * dj == 0 ? "bend" : "shear";
    }

    /// The rows that hold a first end, the first such column, and how many springs a row has.
    [[nodiscard]] int rows(const Grid& grid) const { return grid.ny - dj; }
    [[nodiscard]] int first_column() const { return di < 0 ? -di : 0; }
    [[nodiscard]] int count(const Grid& grid) const { return grid.nx - (di < 0 ? -di : di); }

    /// From the number of the first end to that of the second.
    [[nodiscard]] int offset(const Grid& grid) const { return dj * grid.nx + di; }

    /// Calls visit(a, b) for each spring by its two ends, row by row; with first ends in some of the rows.
    template <class Visit>
    void for_each(const Grid& grid, int from, int end, Visit visit) const {
        for (int j = from; j < std::min(end, rows(grid)); ++j) {
            const int first = grid.particle(first_column(), j);
            for (int a = first; a < first + count(grid); ++a) visit(a, a + offset(grid));
        }
    }
    template <class Visit>
    void for_each(const Grid& grid, Visit visit) const {
        for_each(grid, 0, grid.ny, visit);
    }
};

/// The springs of one direction whose first ends are in some rows of a cloth.
struct SpringRows {
    const SpringStencil& springs;
    const Grid& grid;
    int from, end;

    template <class Visit>
    void for_each(Visit visit) const {
        springs.for_each(grid, from, end, visit);
    }
};

/// From a spring's first end to its second, in columns and rows.
struct SpringDirection {
    int di, dj;
};

/// The six directions of a cloth's springs: structural, shear, bend, two each.
/// @cite provot1995
inline constexpr std::array<SpringDirection, 6> spring_directions{{{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 0}, {0, 2}}};

/// The springs of all directions.
inline std::array<SpringStencil, 6> spring_stencils(const ClothModel& model) {
    const Real hx = model.hx, hy = model.hy, diagonal = std::sqrt(hx * hx + hy * hy);
    const auto springs = [](std::size_t direction, const SpringLaw& law, Real rest_length) {
        const auto [di, dj] = spring_directions[direction];
        return SpringStencil{di, dj, law, rest_length};
    };
    return {springs(0, model.structural, hx),  springs(1, model.structural, hy), springs(2, model.shear, diagonal),
            springs(3, model.shear, diagonal), springs(4, model.bend, 2 * hx),   springs(5, model.bend, 2 * hy)};
}

/// Calls visit(springs, other) for each spring at a particle: its direction, and its other end.
template <class Visit>
void for_each_spring_at(const ClothModel& model, int particle, Visit visit) {
    const Grid& grid = model.grid;
    const int column = particle % grid.nx, row = particle / grid.nx;
    for (const SpringStencil& springs : spring_stencils(model)) {
        for (const int sign : {1, -1}) {
            const int i = column + sign * springs.di, j = row + sign * springs.dj;
            if (i >= 0 && i < grid.nx && j >= 0 && j < grid.ny) visit(springs, grid.particle(i, j));
        }
    }
}

}  // namespace drape
