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
struct PairTraversal {
    NodesInSpace<Volume> first_tree, second_tree;
    Real margin;                   ///< with what the volumes lack [m]
    const FoldTest* folds;         ///< of the first tree, to be asked where it is traversed against itself; null: none
    std::span<NodeVisit> visits;   ///< what is done with each node of the first
    std::vector<LeafPair>& pairs;  ///< receives the leaves
    TraversalStats stats;

    /// A node against itself: each child against itself, and against those after it.
    void traverse_itself(int n) {
        const QuadtreeNode& node = first_tree.nodes[at(n)];
        ++stats.visited;
        if (folds && folds->node_is_separated(n, margin)) return mark(n, NodeVisit::Pruned);
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
        const QuadtreeNode &node = first_tree.nodes[at(n)], &other = second_tree.nodes[at(m)];
        ++stats.visited;
        ++stats.volume_tests;
        const bool are_near = first_tree.volumes[at(n)].comes_within(second_tree.volumes[at(m)], margin);
        if (!are_near) return mark(n, NodeVisit::Pruned);
        if (folds && folds->nodes_are_separated(n, m, margin)) return mark(n, NodeVisit::Pruned);
        if (node.children == 0 && other.children == 0) return take(n, m);
        mark(n, NodeVisit::Entered);
        const int first = node.children > 0 ? node.first_child : n, count = std::max(node.children, 1);
        const int other_first = other.children > 0 ? other.first_child : m, others = std::max(other.children, 1);
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j < others; ++j) traverse(first + i, other_first + j);
        }
    }

private:
    static std::size_t at(int n) { return static_cast<std::size_t>(n); }

    void mark(int n, NodeVisit visit) { visits[at(n)] = std::max(visits[at(n)], visit); }

    void take(int n, int m) {
        mark(n, NodeVisit::Leaf);
        const QuadtreeNode &node = first_tree.nodes[at(n)], &other = second_tree.nodes[at(m)];
        pairs.push_back({node, other});
        ++stats.leaves;
        stats.candidates += static_cast<std::int64_t>(node.cells()) * other.cells();
    }
};

}  // namespace drape
