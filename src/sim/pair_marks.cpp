#include "drape/sim/pair_marks.h"

#include <algorithm>

#include "drape/bounds/fold_test.h"

namespace drape {

TraversalStats mark_pairs(std::span<Cloth> cloths, std::span<const ContactRow> rows, const ContactSettings& contact,
                          std::vector<std::vector<int>>& touched) {
    touched.assign(cloths.size(), {});
    for (const ContactRow& row : rows) {
        if (row.kind != RowKind::Pair) continue;
        for (const RowParticle& p : row.moved()) {
            const auto c = static_cast<std::size_t>(p.cloth);
            const Grid& grid = cloths[c].model.grid;
            const int i = std::min(p.particle % grid.nx, grid.cell_columns() - 1),
                      j = std::min(p.particle / grid.nx, grid.cell_rows() - 1);
            touched[c].push_back(j * grid.cell_columns() + i);
        }
    }
    TraversalStats stats;
    std::vector<LeafPair> leaves;
    for (std::size_t first = 0; first < cloths.size(); ++first) {
        const ClothModel& model = cloths[first].model;
        FoldTest folds(model.grid, model.hx, model.hy, contact.leaf_cells);
        folds.build(cloths[first].state.x);
        BroadPhase& one = cloths[first].search.hierarchy();
        stats += one.query(one, contact.thickness, &folds, leaves);
        for (std::size_t second = first + 1; second < cloths.size(); ++second) {
            BroadPhase& other = cloths[second].search.hierarchy();
            stats += one.query(other, contact.thickness, nullptr, leaves);
            // A search marks the nodes of the first alone
            other.query(one, contact.thickness, nullptr, leaves);
        }
    }
    return stats;
}

}  // namespace drape
