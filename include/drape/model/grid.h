#pragma once

#include <array>
#include <utility>

namespace drape {

/// The cloth's topology: nx columns and ny rows of particles, and the cells and triangles between them.
/// Invariant: nx >= 2 and ny >= 2. Particle p = j*nx + i stands at column i, row j; cell c = j*(nx-1) + i has the
/// corners a=(i,j), b=(i+1,j), c=(i,j+1), d=(i+1,j+1); triangle 2c is a,c,b and triangle 2c+1 is b,c,d.
struct Grid {
    int nx = 2;
    int ny = 2;

    [[nodiscard]] int particles() const { return nx * ny; }
    [[nodiscard]] int cell_columns() const { return nx - 1; }
    [[nodiscard]] int cell_rows() const { return ny - 1; }
    [[nodiscard]] int cells() const { return (nx - 1) * (ny - 1); }
    [[nodiscard]] int triangles() const { return 2 * cells(); }
    [[nodiscard]] int particle(int i, int j) const { return j * nx + i; }

    [[nodiscard]] int cell(int i, int j) const { return j * cell_columns() + i; }

    /// The particle at corner a of a cell; b, c and d follow at +1, +nx and +nx+1.
    [[nodiscard]] int cell_corner(int cell) const { return cell + cell / (nx - 1); }

    /// The three particles of a triangle, counter-clockwise as seen from its front.
    [[nodiscard]] std::array<int, 3> triangle_corners(int triangle) const {
        const int a = cell_corner(triangle / 2);
        if (triangle % 2 == 0) return {a, a + nx, a + 1};
        return {a + 1, a + nx, a + nx + 1};
    }

    bool operator==(const Grid&) const = default;
};

/// A rectangle of cells: columns [i0, i1), rows [j0, j1).
struct CellRange {
    int i0, j0, i1, j1;

    [[nodiscard]] bool holds(int i, int j) const { return i >= i0 && i < i1 && j >= j0 && j < j1; }
    [[nodiscard]] int cells() const { return (i1 - i0) * (j1 - j0); }

    /// Row and column of its first cell: sorted by these, ranges of a row each are in the order of their cells.
    [[nodiscard]] std::pair<int, int> first() const { return {j0, i0}; }

    bool operator==(const CellRange&) const = default;
};

/// All cells of a grid.
inline CellRange all_cells(const Grid& grid) { return {0, 0, grid.cell_columns(), grid.cell_rows()}; }

/// Calls visit(i, j) for each cell of a range, row by row.
template <class Visit>
void for_each_cell_of(const CellRange& cells, Visit visit) {
    for (int j = cells.j0; j < cells.j1; ++j) {
        for (int i = cells.i0; i < cells.i1; ++i) visit(i, j);
    }
}

}  // namespace drape
