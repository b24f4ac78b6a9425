#pragma once

#include <cstdint>
#include <vector>

#include "drape/bounds/bounding_volume.h"
#include "drape/model/grid.h"

namespace drape {

/// A rectangle of cells in the quadtree over the grid.
/// Invariants: the children's rectangles tile their parent's; a node without children has at most leaf_cells x
/// leaf_cells cells; children follow one another and come after their parent.
struct QuadtreeNode : CellRange {
    int first_child = 0;
    int children = 0;  ///< 0 for a leaf, else 2 or 4
    int level = 0;
};

/// What a query did with a node.
enum class NodeVisit : std::uint8_t {
    Unvisited,
    Pruned,   ///< it does not overlap the ball
    Entered,  ///< it does, and its children were visited, or stand for it
    Leaf      ///< it does, and its cells are candidates
};

/// The nodes of a quadtree over a grid of cells, level by level from the root. It depends on the grid alone. Nodes are
/// cut along multiples of `leaf_cells`, so that all leaves but those at the far sides have the full size, for which
/// vectors fit.
/// @param leaf_cells 1 or more; 0: what was measured to be the fastest for build and query together, 7 for small
/// cloths, of which a row of particles fills a vector of 8, and 15 for large ones
/// @par Cost O(nodes)
std::vector<QuadtreeNode> make_quadtree_nodes(const Grid& grid, int leaf_cells);

/// The particles of a rectangle of cells, a node's say.
inline Patch patch_of(const Grid& grid, const CellRange& node, const Points& x) {
    const int first = grid.particle(node.i0, node.j0);
    return {x.col(0).data() + first, x.col(1).data() + first, x.col(2).data() + first,
            node.i1 - node.i0 + 1,   node.j1 - node.j0 + 1,   grid.nx};
}

}  // namespace drape
