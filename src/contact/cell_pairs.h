#pragma once

#include <span>

#include "drape/contact/near_pairs.h"

namespace drape {

/// Calls visit(cell) for each cell of a range.
template <class Visit>
void for_each_cell_of(const Grid& grid, const CellRange& cells, Visit visit) {
    for (int j = cells.j0; j < cells.j1; ++j) {
        for (int i = cells.i0; i < cells.i1; ++i) visit(j * grid.cell_columns() + i);
    }
}

/// Calls visit(from, to) for the edges that belong to a cell, so that each edge belongs to one: from its corner a to b
/// and c, the diagonal, and at the far sides of the cloth what no other cell has.
template <class Visit>
void for_each_edge_of(const Grid& grid, int cell, Visit visit) {
    const int a = grid.cell_corner(cell), b = a + 1, c = a + grid.nx, d = c + 1;
    visit(a, b), visit(a, c), visit(b, c);
    if (cell % grid.cell_columns() == grid.cell_columns() - 1) visit(b, d);
    if (cell / grid.cell_columns() == grid.cell_rows() - 1) visit(c, d);
}

/// The same for particles: corner a, and at the far sides those that no other cell has.
template <class Visit>
void for_each_particle_of(const Grid& grid, int cell, Visit visit) {
    const int a = grid.cell_corner(cell), b = a + 1, c = a + grid.nx, d = c + 1;
    const bool last_column = cell % grid.cell_columns() == grid.cell_columns() - 1;
    const bool last_row = cell / grid.cell_columns() == grid.cell_rows() - 1;
    visit(a);
    if (last_column) visit(b);
    if (last_row) visit(c);
    if (last_column && last_row) visit(d);
}

/// Calls visit(one, two) for each pair of cells in pairs of leaves whose boxes meet; of one leaf, once for each.
template <class Visit>
void for_each_pair_of_cells(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves,
                            Visit visit) {
    for (const auto& [cells, others] : leaves) {
        const bool same = first.cloth.number == second.cloth.number && cells == others;
        const Aabb around = second.boxes.of(second.cloth.grid, others);
        for_each_cell_of(first.cloth.grid, cells, [&](int one) {
            if (!first.boxes[one].comes_within(around, 0)) return;
            for_each_cell_of(second.cloth.grid, others, [&](int two) {
                if (same && two < one) return;
                if (first.boxes[one].comes_within(second.boxes[two], 0)) visit(one, two);
            });
        });
    }
}

}  // namespace drape
