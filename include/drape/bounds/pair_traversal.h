#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "drape/bounds/bounding_volume.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/fold_test.h"
#include "drape/bounds/node_view.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape {

/// The nodes of a tree and their volumes.
template <BoundingVolume Volume>
struct NodesInSpace {
    std::span<const QuadtreeNode> nodes;
    std::span<const Volume> volumes;
};

/// Two trees, or one against itself, gone down in pairs of nodes to the pairs of leaves that are no farther from each
/// other than a margin.
template <BoundingVolume Volume>
class PairTraversal {
public:
    /// @param margin with what the volumes lack [m]
    /// @param folds of the first tree, to be asked where it is traversed against itself; null: none
    /// @param visits what is done with each node of the first
    /// @param pairs receives the leaves; cleared first
    PairTraversal(const NodesInSpace<Volume>& first, const NodesInSpace<Volume>& second, Real margin,
                  const FoldTest* folds, std::span<NodeVisit> visits, std::vector<LeafPair>& pairs)
        : first_(first), second_(second), margin_(margin), folds_(folds), visits_(visits), pairs_(pairs) {
        pairs_.clear();
        stats_.nodes = static_cast<std::int64_t>(first.nodes.size());
    }

    TraversalStats of_one() {
        traverse_itself(0);
        return stats_;
    }
    TraversalStats of_two() {
        traverse(0, 0);
        return stats_;
    }

private:
    static std::size_t at(int n) { return static_cast<std::size_t>(n); }

    void mark(int n, NodeVisit visit) { visits_[at(n)] = std::max(visits_[at(n)], visit); }

    /// A node against itself: each child against itself, and against those after it.
    void traverse_itself(int n) {
        const QuadtreeNode& node = first_.nodes[at(n)];
        ++stats_.visited;
        if (folds_ && folds_->node_is_separated(n, margin_)) return mark(n, NodeVisit::Pruned);
        if (node.children == 0) return take(n, n);
        mark(n, NodeVisit::Entered);
        for (int child = 0; child < node.children; ++child) {
            traverse_itself(node.first_child + child);
            for (int next = child + 1; next < node.children; ++next) {
                traverse(node.first_child + child, node.first_child + next);
            }
        }
    }

    /// A node against one of the second tree: the children of both, where both have any.
    void traverse(int n, int m) {
        const QuadtreeNode &node = first_.nodes[at(n)], &other = second_.nodes[at(m)];
        ++stats_.visited;
        ++stats_.volume_tests;
        if (!first_.volumes[at(n)].comes_within(second_.volumes[at(m)], margin_)) return mark(n, NodeVisit::Pruned);
        if (folds_ && folds_->nodes_are_separated(n, m, margin_)) return mark(n, NodeVisit::Pruned);
        if (node.children == 0 && other.children == 0) return take(n, m);
        mark(n, NodeVisit::Entered);
        const int first = node.children > 0 ? node.first_child : n, count = std::max(node.children, 1);
        const int other_first = other.children > 0 ? other.first_child : m, others = std::max(other.children, 1);
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j < others; ++j) traverse(first + i, other_first + j);
        }
    }

    void take(int n, int m) {
        mark(n, NodeVisit::Leaf);
        const QuadtreeNode &node = first_.nodes[at(n)], &other = second_.nodes[at(m)];
        pairs_.push_back({node, other});
        ++stats_.leaves;
        stats_.candidates += static_cast<std::int64_t>(node.cells()) * other.cells();
    }

    NodesInSpace<Volume> first_, second_;
    Real margin_;
    const FoldTest* folds_;
    std::span<NodeVisit> visits_;
    std::vector<LeafPair>& pairs_;
    TraversalStats stats_;
};

}  // namespace drape
