#include "drape/sim/pair_marks.h"

#include <algorithm>

#include "drape/bounds/fold_test.h"

namespace drape {

TraversalStats PairMarks::mark(std::span<Cloth> cloths, std::span<const ContactRow> rows,
                               const ContactSettings& contact) {
    touched_.resize(cloths.size());
    for (std::vector<int>& cells : touched_) cells.clear();
    for (const ContactRow& row : rows) {
        if (row.kind != RowKind::Pair) continue;
        for (const RowParticle& p : row.moved()) {
            const auto c = static_cast<std::size_t>(p.cloth);
            const Grid& grid = cloths[c].model.grid;
            const int i = std::min(p.particle % grid.nx, grid.cell_columns() - 1),
                      j = std::min(p.particle / grid.nx, grid.cell_rows() - 1);
            touched_[c].push_back(j * grid.cell_columns() + i);
        }
    }
    TraversalStats stats;
    for (std::size_t first = 0; first < cloths.size(); ++first) {
        const ClothModel& model = cloths[first].model;
        FoldTest folds(model.grid, model.hx, model.hy, contact.leaf_cells);
        folds.build(cloths[first].state.x);
        for (std::size_t second = first; second < cloths.size(); ++second) {
            const ContactSearch& other = cloths[second].search;
            const FoldTest* of_itself = first == second ? &folds : nullptr;
            stats += cloths[first].search.mark_pairs(other, contact.thickness, of_itself, leaves_);
            // A search marks the nodes of the first alone
            if (first != second) cloths[second].search.mark_pairs(cloths[first].search, contact.thickness, {}, leaves_);
        }
    }
    return stats;
}

}  // namespace drape
