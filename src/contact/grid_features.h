#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "drape/base/real.h"
#include "drape/model/grid.h"

namespace drape {

/// The triangle whose task it is to report a particle: one of those it is a corner of, for each particle the same.
inline int owner_of(const Grid& grid, int particle) {
    const int i = particle % grid.nx, j = particle / grid.nx;
    const int cell = grid.cell(std::min(i, grid.nx - 2), std::min(j, grid.ny - 2));
    return 2 * cell + (i == grid.nx - 1 && j == grid.ny - 1 ? 1 : 0);
}

/// Calls visit(particle) for those that belong to a cell, so that each belongs to one: its first corner, and at the far
/// sides of the cloth what no other cell has.
template <class Visit>
void for_each_particle_of(const Grid& grid, int column, int row, Visit visit) {
    const int a = grid.particle(column, row);
    const bool last_column = column == grid.cell_columns() - 1, last_row = row == grid.cell_rows() - 1;
    visit(a);
    if (last_column) visit(a + 1);
    if (last_row) visit(a + grid.nx);
    if (last_column && last_row) visit(a + grid.nx + 1);
}

/// Whether two triangles share the edge opposite to corner k of the first, and the other one is to report it.
inline bool other_reports_edge(const Grid& grid, int triangle, std::size_t k) {
    // Corners a, c, b and b, c, d: the diagonal b-c is opposite to a and to d and is reported by the first triangle of
    // the cell; the sides of a cell are reported by the triangle with the lower number, of the cell above or to the
    // left
    const int cell = triangle / 2;
    const bool first = triangle % 2 == 0;
    if (!first) return k == 2;
    if (k == 0) return false;
    return k == 1 ? cell >= grid.cell_columns() : cell % grid.cell_columns() > 0;
}

/// What of a triangle a point with some weights is on: how many weights are zero, and which corner the last of them is
/// of: the one opposite to the edge, where it is one.
struct OnTriangle {
    int zeros = 0;
    std::size_t opposite = 0;
};

inline OnTriangle feature_at(const std::array<Real, 3>& weights) {
    OnTriangle on;
    for (std::size_t k = 0; k < 3; ++k) {
        if (weights[k] == 0) ++on.zeros, on.opposite = k;
    }
    return on;
}

/// Whether a triangle's point with some weights is one that it does not report as its own: a corner, or on an edge that
/// another triangle reports.
inline bool reported_elsewhere(const Grid& grid, int triangle, const std::array<Real, 3>& weights) {
    const OnTriangle on = feature_at(weights);
    return on.zeros == 2 || (on.zeros == 1 && other_reports_edge(grid, triangle, on.opposite));
}

}  // namespace drape
