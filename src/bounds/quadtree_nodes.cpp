#include "drape/bounds/quadtree_nodes.h"

#include <utility>

#include "drape/base/assert.h"

namespace drape {
namespace {

/// Where a range of cells is cut in two, or its end if it is short enough for a leaf.
int cut(int begin, int end, int leaf_cells) {
    const int leaves = (end - begin + leaf_cells - 1) / leaf_cells;
    return leaves > 1 ? begin + (leaves + 1) / 2 * leaf_cells : end;
}

}  // namespace

std::vector<QuadtreeNode> make_quadtree_nodes(const Grid& grid, int leaf_cells) {
    DRAPE_ASSERT(leaf_cells >= 0);
    constexpr int large = 10'000;  // cells
    if (leaf_cells == 0) leaf_cells = grid.cells() < large ? 7 : 15;
    std::vector<QuadtreeNode> nodes{{{0, 0, grid.cell_columns(), grid.cell_rows()}}};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const QuadtreeNode parent = nodes[n];
        const int i_cut = cut(parent.i0, parent.i1, leaf_cells), j_cut = cut(parent.j0, parent.j1, leaf_cells);
        if (i_cut == parent.i1 && j_cut == parent.j1) continue;

        // Four quarters, or two halves where the other side is short already
        nodes[n].first_child = static_cast<int>(nodes.size());
        for (const auto& [j0, j1] : {std::pair(parent.j0, j_cut), std::pair(j_cut, parent.j1)}) {
            for (const auto& [i0, i1] : {std::pair(parent.i0, i_cut), std::pair(i_cut, parent.i1)}) {
                if (i0 == i1 || j0 == j1) continue;
                nodes.push_back({{i0, j0, i1, j1}, 0, 0, parent.level + 1});
                ++nodes[n].children;
            }
        }
    }
    return nodes;
}

}  // namespace drape
