#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "drape/base/assert.h"
#include "drape/bounds/bounding_volume.h"
#include "drape/bounds/broad_phase.h"

namespace drape {

/// A rectangle of cells in the quadtree over the grid.
/// Invariants: the children's rectangles tile their parent's; a node without children has at most leaf_cells x
/// leaf_cells cells; children follow one another and come after their parent.
struct QuadtreeNode {
    int i0, j0, i1, j1;  ///< cell columns [i0, i1), cell rows [j0, j1)
    int first_child = 0;
    int children = 0;  ///< 0 for a leaf, else 2 or 4
    int level = 0;

    [[nodiscard]] bool holds(int i, int j) const { return i >= i0 && i < i1 && j >= j0 && j < j1; }
};

/// The nodes of a quadtree over a grid of cells, level by level from the root. It depends on the grid alone.
/// @pre leaf_cells >= 1
/// @par Cost O(nodes)
std::vector<QuadtreeNode> make_quadtree_nodes(const Grid& grid, int leaf_cells);

/// A quadtree over the cloth's cells whose every node carries a volume about its own particles.
/// Invariant after `build`: a node's volume contains all its particles, and so all its triangles, grown by the
/// thickness.
template <BoundingVolume Volume>
class ClothQuadtree final : public BroadPhase {
public:
    ClothQuadtree(const Grid& grid, int leaf_cells)
        : grid_(grid), nodes_(make_quadtree_nodes(grid, leaf_cells)), volumes_(nodes_.size()), states_(nodes_.size()) {}

    /// Top-down: every node, from the root, is fitted to all of its own particles, as the original does it. A node is
    /// followed by all that is below it, while its particles are still in the cache.
    /// @par Cost O(particles * levels)
    void build(const Points& x, Real thickness) override {
        DRAPE_ASSERT(x.rows() == grid_.particles());
        fit_from(0, x, thickness);
        std::fill(states_.begin(), states_.end(), NodeState::Unvisited);
    }

    /// From the root into every node that overlaps the ball; the cells of the leaves reached are the candidates.
    TraversalStats query(const Ball& ball, std::vector<int>& cells) override {
        cells.clear();
        cells.reserve(static_cast<std::size_t>(grid_.cells()));
        TraversalStats stats{.nodes = static_cast<std::int64_t>(nodes_.size())};
        std::array<int, stack_size> stack;
        int top = 0;
        stack[0] = 0;
        while (top >= 0) {
            const int n = stack[static_cast<std::size_t>(top--)];
            const QuadtreeNode& node = nodes_[static_cast<std::size_t>(n)];
            ++stats.visited;
            ++stats.volume_tests;
            if (!volumes_[static_cast<std::size_t>(n)].overlaps(ball)) {
                mark(n, NodeState::Pruned);
            } else if (node.children == 0) {
                mark(n, NodeState::Leaf);
                ++stats.leaves;
                append_cells(node, cells);
            } else {
                mark(n, NodeState::Visited);
                for (int child = node.children - 1; child >= 0; --child) {
                    stack[static_cast<std::size_t>(++top)] = node.first_child + child;
                }
            }
        }
        stats.candidates = static_cast<std::int64_t>(cells.size());
        return stats;
    }

    [[nodiscard]] int levels() const override { return nodes_.back().level + 1; }

    void nodes_at(int level, std::span<const int> touched_cells, std::vector<NodeView>& views) const override {
        views.clear();
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            const QuadtreeNode& node = nodes_[n];
            const bool shown = node.level == level || (node.level < level && node.children == 0);
            if (shown) views.push_back({volumes_[n].placement(), state_of(n, touched_cells)});
        }
    }

    [[nodiscard]] const std::vector<QuadtreeNode>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Volume>& volumes() const { return volumes_; }

private:
    /// Each level leaves at most three siblings waiting, and a grid that fits an int has at most 31 levels.
    static constexpr std::size_t stack_size = 3 * 31 + 4;

    [[nodiscard]] Patch patch_of(const QuadtreeNode& node, const Points& x) const {
        const int first = grid_.particle(node.i0, node.j0);
        return {x.col(0).data() + first, x.col(1).data() + first, x.col(2).data() + first,
                node.i1 - node.i0 + 1,   node.j1 - node.j0 + 1,   grid_.nx};
    }

    void fit_from(int n, const Points& x, Real thickness) {
        const QuadtreeNode& node = nodes_[static_cast<std::size_t>(n)];
        volumes_[static_cast<std::size_t>(n)] = Volume::fit(patch_of(node, x), thickness);
        for (int child = 0; child < node.children; ++child) fit_from(node.first_child + child, x, thickness);
    }

    void append_cells(const QuadtreeNode& node, std::vector<int>& cells) const {
        for (int j = node.j0; j < node.j1; ++j) {
            const int row = j * grid_.cell_columns();
            for (int i = node.i0; i < node.i1; ++i) cells.push_back(row + i);
        }
    }

    /// With several balls a node shows the most that any query did with it.
    void mark(int node, NodeState state) {
        NodeState& kept = states_[static_cast<std::size_t>(node)];
        kept = std::max(kept, state);
    }

    [[nodiscard]] NodeState state_of(std::size_t n, std::span<const int> touched_cells) const {
        if (states_[n] < NodeState::Visited) return states_[n];
        const bool touched = std::any_of(touched_cells.begin(), touched_cells.end(), [&](int cell) {
            return nodes_[n].holds(cell % grid_.cell_columns(), cell / grid_.cell_columns());
        });
        return touched ? NodeState::Touching : states_[n];
    }

    Grid grid_;
    std::vector<QuadtreeNode> nodes_;
    std::vector<Volume> volumes_;
    std::vector<NodeState> states_;  ///< what the queries since the last build did
};

}  // namespace drape
