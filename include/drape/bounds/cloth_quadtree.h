#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "drape/base/assert.h"
#include "drape/bounds/bounding_volume.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/displacement.h"
#include "drape/bounds/fold_test.h"
#include "drape/bounds/node_view.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape {

/// How the nodes of a tree get their volumes from particles.
template <BoundingVolume Volume>
struct Fits {
    /// Fits one node.
    Volume (*patch)(const Patch&);

    /// Fits all nodes, each to all of its own particles, in fewer passes than node by node; null if there is no such
    /// way. `volumes` are those of `nodes`.
    void (*tree)(const Grid& grid, std::span<const QuadtreeNode> nodes, const Points& x,
                 std::span<Volume> volumes) = nullptr;

    /// Fits all leaves, as `patch` does, in the order of the particles; null if there is no such way.
    /// @param leaves their numbers, row by row
    void (*leaves)(const Grid& grid, std::span<const QuadtreeNode> nodes, std::span<const int> leaves, const Points& x,
                   std::span<Volume> volumes) = nullptr;
};

/// The fits of these parameters: plain, or vector kernels.
template <BoundingVolume Volume>
Fits<Volume> fits_of(const BroadPhaseParameters& parameters);

/// A quadtree over the cloth's cells whose every node carries a volume about its own particles. A search for a ball may
/// be limited: it then ends at a level, or after a number of tests, and hands on the nodes it has ended at.
/// Invariant after `build`: a node's volume, grown by `slack`, contains all its particles, and so all its triangles.
template <BoundingVolume Volume>
class ClothQuadtree final : public BroadPhase {
public:
    explicit ClothQuadtree(const Grid& grid, const BroadPhaseParameters& parameters = {})
        : ClothQuadtree(grid, parameters, fits_of<Volume>(parameters)) {}

    ClothQuadtree(const Grid& grid, const BroadPhaseParameters& parameters, Fits<Volume> fits)
        : grid_(grid),
          update_(parameters.update),
          limit_(parameters.search),
          fits_(fits),
          nodes_(make_quadtree_nodes(grid, parameters.leaf_cells)),
          volumes_(nodes_.size()),
          visits_(nodes_.size()) {
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            const QuadtreeNode& node = nodes_[n];
            if (node.children > 0) continue;
            leaf_rows_ += static_cast<std::size_t>(node.j1 - node.j0);
            leaves_.push_back(static_cast<int>(n));
        }
        std::ranges::sort(leaves_, {}, [this](int n) { return nodes_[at(n)].first(); });
    }

    [[nodiscard]] std::unique_ptr<BroadPhase> clone() const override { return std::make_unique<ClothQuadtree>(*this); }

    void build(const Points& x) override {
        DRAPE_ASSERT(x.rows() == grid_.particles());
        switch (update_) {
            case UpdateKind::Rebuild:
                rebuild(x);
                break;
            case UpdateKind::Merge:
                merge(x);
                break;
            case UpdateKind::Insertion:
                insert_all(x);
                break;
            case UpdateKind::Refit:
                refit(x);
                break;
            case UpdateKind::None:
                if (!built_) {
                    rebuild(x);
                    held_ = x;
                }
                slack_ = largest_displacement(x, held_);
                break;
        }
        built_ = true;
        std::ranges::fill(visits_, NodeVisit::Unvisited);
    }

    TraversalStats query(const Ball& ball, Candidates& found) override {
        // Also by the rounding of points as far out as the ball: the exact test of a triangle is not more exact
        const Real size = ball.centre.cwiseAbs().sum() + ball.radius;
        const Ball grown_ball = grown(ball, slack_ + 16 * std::numeric_limits<Real>::epsilon() * size);
        const auto is_apart = [&](const Volume& volume) { return !volume.overlaps(grown_ball); };
        const auto mark_node = [this](int n, NodeVisit visit) { mark(n, visit); };
        return traverse(limit_, is_apart, mark_node, found);
    }

    TraversalStats query(const BroadPhase& other, Real margin, const FoldTest* folds,
                         std::vector<LeafPair>& pairs) override {
        DRAPE_ASSERT(built_ && dynamic_cast<const ClothQuadtree*>(&other) != nullptr);
        const auto& second = static_cast<const ClothQuadtree&>(other);
        pairs.clear();
        PairSearch search{
            second, margin + slack_ + second.slack_, folds, pairs, {.nodes = static_cast<std::int64_t>(nodes_.size())}};
        traverse_pair(0, 0, search);
        return search.stats;
    }

    TraversalStats query_near(const DistanceFunction& distance, Real margin, Candidates& found) override {
        // Where the middle of its sphere is farther from the body than the sphere is wide
        const auto is_apart = [&](const Volume& volume) {
            const BoundingSphere sphere = volume.sphere();
            const Real size = sphere.centre.cwiseAbs().sum() + sphere.radius;
            const Real rounding = 64 * std::numeric_limits<Real>::epsilon() * size;
            return distance(sphere.centre) > sphere.radius + margin + slack_ + rounding;
        };
        const auto leave_unmarked = [](int /*n*/, NodeVisit /*visit*/) {};  // the marks are those of balls
        return traverse({}, is_apart, leave_unmarked, found);
    }

    [[nodiscard]] Real slack() const override { return slack_; }
    [[nodiscard]] int levels() const override { return nodes_.back().level + 1; }

    void nodes_at(int level, std::vector<NodeView>& nodes) const override {
        nodes.clear();
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            const QuadtreeNode& node = nodes_[n];
            const bool shown = node.level == level || (node.level < level && node.children == 0);
            if (shown) nodes.push_back({node, visits_[n], volumes_[n]});
        }
    }

    [[nodiscard]] const std::vector<QuadtreeNode>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Volume>& volumes() const { return volumes_; }

private:
    static std::size_t at(int n) { return static_cast<std::size_t>(n); }

    /// Into every node that is not apart from what is searched for; the cells of the leaves that are not are the
    /// candidates. Level by level from the root down, so that a search that a limit ends has seen all of the cloth
    /// alike.
    /// @param mark told of each node and what is done with it
    /// @cite dissertation @cite hubbard1996
    template <class IsApart, class Mark>
    TraversalStats traverse(const SearchLimit& limit, const IsApart& is_apart, const Mark& mark, Candidates& found) {
        DRAPE_ASSERT(built_);
        found.cells.clear();
        found.cells.reserve(leaf_rows_);
        found.stopped.clear();
        if (!limit.none()) found.stopped.reserve(nodes_.size());
        queue_.reserve(nodes_.size());
        queue_.assign(1, 0);
        TraversalStats stats{.nodes = static_cast<std::int64_t>(nodes_.size())};
        for (std::size_t next = 0; next < queue_.size(); ++next) {
            const int n = queue_[next];
            const QuadtreeNode& node = nodes_[at(n)];
            ++stats.visited;
            const bool spent = limit.tests > 0 && stats.volume_tests == limit.tests;
            if (!spent) ++stats.volume_tests;
            if (!spent && is_apart(volumes_[at(n)])) {
                mark(n, NodeVisit::Pruned);
                ++stats.pruned;
            } else if (spent || (node.level == limit.level && node.children > 0)) {
                mark(n, NodeVisit::Entered);
                found.stopped.push_back(stop_at(n));
            } else if (node.children == 0) {
                mark(n, NodeVisit::Leaf);
                take_leaf(node, found, stats);
            } else {
                mark(n, NodeVisit::Entered);
                for (int child = 0; child < node.children; ++child) queue_.push_back(node.first_child + child);
            }
        }
        stats.stopped = static_cast<std::int64_t>(found.stopped.size());
        return stats;
    }

    /// This tree and another, or itself, gone down in pairs of nodes to the pairs of leaves that are no farther from
    /// each other than a margin.
    struct PairSearch {
        const ClothQuadtree& other;
        Real margin;                   ///< with what the volumes lack [m]
        const FoldTest* folds;         ///< to be asked where this tree is traversed against itself; null: none
        std::vector<LeafPair>& pairs;  ///< receives the leaves
        TraversalStats stats;
    };

    /// A node against one of the other tree: the children of both, where both have any. A node against itself: each
    /// child against itself, and against those after it.
    void traverse_pair(int n, int m, PairSearch& search) {
        const bool itself = &search.other == this && n == m;
        ++search.stats.visited;
        if (!itself) {
            ++search.stats.volume_tests;
            const bool are_near = volumes_[at(n)].comes_within(search.other.volumes_[at(m)], search.margin);
            if (!are_near) return mark(n, NodeVisit::Pruned);
        }
        if (search.folds && (itself ? search.folds->node_is_separated(n, search.margin)
                                    : search.folds->nodes_are_separated(n, m, search.margin))) {
            return mark(n, NodeVisit::Pruned);
        }
        const QuadtreeNode &node = nodes_[at(n)], &other = search.other.nodes_[at(m)];
        if (node.children == 0 && other.children == 0) {
            mark(n, NodeVisit::Leaf);
            search.pairs.push_back({node, other});
            ++search.stats.leaves;
            search.stats.candidates += pairs_of_cells(node.cells(), other.cells(), itself);
            return;
        }
        mark(n, NodeVisit::Entered);
        const int first = node.children > 0 ? node.first_child : n, count = std::max(node.children, 1);
        const int other_first = other.children > 0 ? other.first_child : m, others = std::max(other.children, 1);
        for (int i = 0; i < count; ++i) {
            for (int j = itself ? i : 0; j < others; ++j) traverse_pair(first + i, other_first + j, search);
        }
    }

    [[nodiscard]] StoppedNode stop_at(int n) const {
        const QuadtreeNode& node = nodes_[at(n)];
        BoundingSphere sphere = volumes_[at(n)].sphere();
        sphere.radius += slack_;
        return {node, sphere, grid_.cell((node.i0 + node.i1) / 2, (node.j0 + node.j1) / 2)};
    }

    static void take_leaf(const QuadtreeNode& leaf, Candidates& found, TraversalStats& stats) {
        for (int j = leaf.j0; j < leaf.j1; ++j) found.cells.push_back({leaf.i0, j, leaf.i1, j + 1});
        ++stats.leaves;
        stats.candidates += leaf.cells();
    }

    /// With several balls the most counts that any query did with a node.
    void mark(int n, NodeVisit visit) { visits_[at(n)] = std::max(visits_[at(n)], visit); }

    /// Top-down: every node is fitted to all of its own particles. @cite dissertation
    /// @par Cost O(particles * levels)
    void rebuild(const Points& x) { fits_.tree ? fits_.tree(grid_, nodes_, x, volumes_) : rebuild_from(0, x); }

    /// A node is followed by all that is below it, while its particles are still in the cache.
    void rebuild_from(int n, const Points& x) {
        const QuadtreeNode& node = nodes_[at(n)];
        volumes_[at(n)] = fits_.patch(patch_of(grid_, node, x));
        for (int child = 0; child < node.children; ++child) rebuild_from(node.first_child + child, x);
    }

    /// Bottom-up: leaves from particles, all others from their children.
    /// @par Cost O(particles)
    void merge(const Points& x) {
        if (fits_.leaves) fits_.leaves(grid_, nodes_, leaves_, x, volumes_);
        for (std::size_t n = nodes_.size(); n-- > 0;) {
            const QuadtreeNode& node = nodes_[n];
            if (node.children > 0)
                volumes_[n] = merged(node);
            else if (!fits_.leaves)
                volumes_[n] = fits_.patch(patch_of(grid_, node, x));
        }
    }

    /// Cell by cell: each goes from the root down to its leaf, and every volume on its way grows by its particles.
    /// @cite dissertation
    /// @par Cost O(cells * levels)
    void insert_all(const Points& x) {
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            volumes_[n] = Volume::start(patch_of(grid_, nodes_[n], x));
        }
        for_each_cell_of(all_cells(grid_), [&](int i, int j) {
            const int above = grid_.particle(i, j), below = grid_.particle(i, j + 1);
            for (int n = 0;;) {
                for (const int p : {above, above + 1, below, below + 1}) volumes_[at(n)].include(x.row(p).transpose());
                const QuadtreeNode& node = nodes_[at(n)];
                if (node.children == 0) return;
                n = node.first_child;
                while (!nodes_[at(n)].holds(i, j)) ++n;
            }
        });
    }

    Volume merged(const QuadtreeNode& node) const {
        return Volume::merge(std::span(volumes_).subspan(at(node.first_child), at(node.children)));
    }

    /// A leaf counts as moved where a particle is farther from where it was fitted than a fiftieth of the leaf's size,
    /// and until then the slack makes up for it. The first time all of them have.
    /// @par Cost O(particles) to see what has moved, and a merge of that
    void refit(const Points& x) {
        stale_.resize(nodes_.size());
        copies_.resize(nodes_.size());
        for (std::size_t n = nodes_.size(); n-- > 0;) {
            const QuadtreeNode& node = nodes_[n];
            if (node.children == 0) {
                const Patch patch = patch_of(grid_, node, x);
                stale_[n] = !built_ || !(largest_displacement(patch, copies_[n]) <= slack_);
                if (!stale_[n]) continue;
                volumes_[n] = fits_.patch(patch);
                copy_points(patch, copies_[n]);
            } else {
                const auto first = stale_.begin() + node.first_child;
                stale_[n] = std::find(first, first + node.children, true) != first + node.children;
                if (stale_[n]) volumes_[n] = merged(node);
            }
        }
        if (built_) return;
        Real radii = 0;
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            if (nodes_[n].children == 0) radii += volumes_[n].sphere().radius;
        }
        slack_ = radii / static_cast<Real>(leaves_.size()) / 50;
    }

    Grid grid_;
    UpdateKind update_;
    SearchLimit limit_;
    Fits<Volume> fits_;
    std::vector<QuadtreeNode> nodes_;
    std::vector<Volume> volumes_;
    std::vector<NodeVisit> visits_;
    std::vector<int> leaves_;    ///< numbers of nodes, row by row
    std::vector<int> queue_;     ///< nodes that a search visits
    std::size_t leaf_rows_ = 0;  ///< of all leaves together: the most ranges of cells that a query finds
    bool built_ = false;
    Real slack_ = 0;
    /// For refit: the particles that each leaf was last fitted to. Leaves share those on their borders, and may be
    /// fitted at different times: each has its own copy.
    std::vector<Points> copies_;
    std::vector<bool> stale_;  ///< for refit: volumes that have just changed
    Points held_;              ///< for a stale tree: what it was built from
};

}  // namespace drape
