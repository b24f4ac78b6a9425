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
