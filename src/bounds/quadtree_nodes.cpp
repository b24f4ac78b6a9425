#include "drape/bounds/quadtree_nodes.h"

#include <algorithm>
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

int measured_leaf_cells(const Grid& grid) {
    constexpr int large = 10'000;  // cells
    return grid.cells() < large ? 7 : 15;
}

std::vector<QuadtreeNode> make_quadtree_nodes(const Grid& grid, int leaf_cells) {
    DRAPE_ASSERT(leaf_cells >= 0);
    if (leaf_cells == 0) leaf_cells = measured_leaf_cells(grid);
    std::vector<QuadtreeNode> nodes{{.i0 = 0, .j0 = 0, .i1 = grid.cell_columns(), .j1 = grid.cell_rows()}};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const QuadtreeNode parent = nodes[n];
        const int i_cut = cut(parent.i0, parent.i1, leaf_cells), j_cut = cut(parent.j0, parent.j1, leaf_cells);
        if (i_cut == parent.i1 && j_cut == parent.j1) continue;

        // Four quarters, or two halves where the other side is short already
        nodes[n].first_child = static_cast<int>(nodes.size());
        for (const auto& [j0, j1] : {std::pair(parent.j0, j_cut), std::pair(j_cut, parent.j1)}) {
            for (const auto& [i0, i1] : {std::pair(parent.i0, i_cut), std::pair(i_cut, parent.i1)}) {
                if (i0 == i1 || j0 == j1) continue;
                nodes.push_back({.i0 = i0, .j0 = j0, .i1 = i1, .j1 = j1, .level = parent.level + 1});
                ++nodes[n].children;
            }
        }
    }
    return nodes;
}

std::vector<int> leaves_in_rows(const std::vector<QuadtreeNode>& nodes) {
    std::vector<int> leaves;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].children == 0) leaves.push_back(static_cast<int>(n));
    }
    std::ranges::sort(leaves, {}, [&](int leaf) {
        const QuadtreeNode& node = nodes[static_cast<std::size_t>(leaf)];
        return std::pair(node.j0, node.i0);
    });
    return leaves;
}

void prefetch_below(const Grid& grid, const QuadtreeNode& leaf, const Points& x) {
    constexpr int line = 64 / static_cast<int>(sizeof(Real));  // of a cache, in particles
    const int rows = leaf.j1 - leaf.j0, start = grid.particle(leaf.i0 * rows, leaf.j1 + 1);
    const int end = std::min(start + (leaf.i1 - leaf.i0) * rows, grid.particles());
    for (int axis = 0; axis < 3; ++axis) {
        const Real* const coordinate = x.col(axis).data();
        for (int p = start; p < end; p += line) __builtin_prefetch(coordinate + p);
    }
}

}  // namespace drape
