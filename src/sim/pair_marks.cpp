#include "drape/sim/pair_marks.h"

#include <algorithm>

namespace drape {

TraversalStats PairMarks::mark(std::span<Cloth> cloths, std::span<const ContactRow> rows,
                               const ContactSettings& contact) {
    follow(cloths, contact);
    for (const ContactRow& row : rows) {
        if (row.kind != RowKind::Pair) continue;
        for (const RowParticle& p : row.moved()) {
            OfCloth& cloth = of_cloths_[static_cast<std::size_t>(p.cloth)];
            const int i = p.particle % cloth.grid.nx, j = p.particle / cloth.grid.nx;
            const int column = std::min(i, cloth.grid.cell_columns() - 1),
                      line = std::min(j, cloth.grid.cell_rows() - 1);
            cloth.touched.push_back(line * cloth.grid.cell_columns() + column);
        }
    }
    TraversalStats stats;
    for (std::size_t first = 0; first < cloths.size(); ++first) {
        for (std::size_t second = first; second < cloths.size(); ++second) {
            const ContactSearch& other = cloths[second].search;
            const FoldTest* folds = first == second ? &of_cloths_[first].folds : nullptr;
            stats += cloths[first].search.mark_pairs(other, contact.thickness, folds, leaves_);
            // A search marks the nodes of the first alone
            if (first != second) cloths[second].search.mark_pairs(cloths[first].search, contact.thickness, {}, leaves_);
        }
    }
    return stats;
}

void PairMarks::follow(std::span<const Cloth> cloths, const ContactSettings& contact) {
    of_cloths_.resize(cloths.size());
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        const ClothModel& model = cloths[c].model;
        OfCloth& of = of_cloths_[c];
        const bool same = of.grid == model.grid && of.hx == model.hx && of.hy == model.hy;
        if (!same || of.leaf_cells != contact.leaf_cells) {
            of.grid = model.grid;
            of.hx = model.hx;
            of.hy = model.hy;
            of.leaf_cells = contact.leaf_cells;
            of.folds = FoldTest(of.grid, of.hx, of.hy, of.leaf_cells);
        }
        of.folds.build(cloths[c].state.x);
        of.touched.clear();
    }
}

}  // namespace drape
