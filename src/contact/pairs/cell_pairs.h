#pragma once

#include <algorithm>
#include <span>

#include "drape/contact/near_pairs.h"

namespace drape {

/// Calls visit(from, to) for the edges that belong to a cell, so that each edge belongs to one: from its corner a to b
/// and c, the diagonal, and at the far sides of the cloth what no other cell has.
template <class Visit>
void for_each_edge_of(const Grid& grid, int cell, Visit visit) {
    const int a = grid.cell_corner(cell), b = a + 1, c = a + grid.nx, d = c + 1;
    visit(a, b), visit(a, c), visit(b, c);
    if (cell % grid.cell_columns() == grid.cell_columns() - 1) visit(b, d);
    if (cell / grid.cell_columns() == grid.cell_rows() - 1) visit(c, d);
}

/// The smallest range that has all cells of a range whose boxes meet a box; empty if none does.
inline CellRange those_that_meet(const Aabb& box, const BoxedCloth& cloth, const CellRange& cells) {
    CellRange met{cells.i1, cells.j1, cells.i0, cells.j0};
    for_each_cell_of(cells, [&](int i, int j) {
        if (!cloth.boxes.of(cloth.cloth.grid.cell(i, j)).meets(box)) return;
        met = {std::min(met.i0, i), std::min(met.j0, j), std::max(met.i1, i + 1), std::max(met.j1, j + 1)};
    });
    return met;
}

/// Calls visit(one, two) for each pair of cells in pairs of leaves whose boxes meet; of one leaf, once for each.
template <class Visit>
void for_each_pair_of_cells(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves,
                            Visit visit) {
    for (const auto& [cells, others] : leaves) {
        const bool same = first.cloth.number == second.cloth.number && cells == others;
        const Aabb around = second.boxes.of(second.cloth.grid, others);
        const CellRange near = same ? cells : those_that_meet(around, first, cells);
        if (near.i0 >= near.i1) continue;
        const Aabb around_near = first.boxes.of(first.cloth.grid, near);
        const CellRange there = same ? cells : those_that_meet(around_near, second, others);
        for_each_cell_of(near, [&](int i, int j) {
            const int one = first.cloth.grid.cell(i, j);
            for_each_cell_of(there, [&](int other_i, int other_j) {
                const int two = second.cloth.grid.cell(other_i, other_j);
                if (same && two < one) return;
                if (first.boxes.of(one).meets(second.boxes.of(two))) visit(one, two);
            });
        });
    }
}

}  // namespace drape
