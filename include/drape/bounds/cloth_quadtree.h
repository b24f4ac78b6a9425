#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "drape/base/assert.h"
#include "drape/bounds/bounding_volume.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/leaf_copies.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape {

/// How the nodes of a tree get their volumes from particles.
template <BoundingVolume Volume>
struct Fits {
    /// Fits one node.
    Volume (*patch)(const Patch&) = Volume::fit;

    /// Fits all nodes, each to all of its own particles, in fewer passes than node by node; null if there is no such
    /// way. `volumes` are those of `nodes`.
    void (*tree)(const Grid& grid, std::span<const QuadtreeNode> nodes, const Points& x,
                 std::span<Volume> volumes) = nullptr;
};

/// A quadtree over the cloth's cells whose every node carries a volume about its own particles.
/// Invariant after `build`: a node's volume, grown by `slack`, contains all its particles, and so all its triangles.
template <BoundingVolume Volume>
class ClothQuadtree final : public BroadPhase {
public:
    explicit ClothQuadtree(const Grid& grid, const BroadPhaseParameters& parameters = {}, Fits<Volume> fits = {})
        : grid_(grid),
          update_(parameters.update),
          search_(parameters.search),
          fits_(fits),
          nodes_(make_quadtree_nodes(grid, parameters.leaf_cells)),
          leaves_(leaves_in_rows(nodes_)),
          volumes_(nodes_.size()),
          states_(nodes_.size()) {
        open_.reserve(nodes_.size());
        for (const int n : leaves_) leaf_rows_ += at(nodes_[at(n)].j1 - nodes_[at(n)].j0);
    }

    void build(const Points& x) override {
        DRAPE_ASSERT(x.rows() == grid_.particles());
        switch (update_) {
            case UpdateKind::Rebuild:
                rebuild(x);
                break;
            case UpdateKind::Merge:
                merge(x);
                break;
            case UpdateKind::Refit:
                built_ ? refit(x) : start_refitting(x);
                break;
            case UpdateKind::None:
                built_ ? hold(x) : start_holding(x);
                break;
        }
        built_ = true;
        std::fill(states_.begin(), states_.end(), NodeState::Unvisited);
    }

    /// From the root, level by level, into every node that overlaps the ball; the cells of the leaves reached are the
    /// candidates.
    TraversalStats query(const Ball& ball, Candidates& found) override {
        DRAPE_ASSERT(built_);
        found.cells.clear();
        found.cells.reserve(leaf_rows_);
        found.stopped.clear();
        if (!search_.none()) found.stopped.reserve(nodes_.size());
        TraversalStats stats{.nodes = static_cast<std::int64_t>(nodes_.size())};
        const Ball reached = grown(ball, slack_ + rounding(ball));
        open_.assign(1, 0);
        for (std::size_t next = 0; next < open_.size(); ++next) {
            const int n = open_[next];
            const QuadtreeNode& node = nodes_[at(n)];
            ++stats.visited;
            const bool spent = search_.tests > 0 && stats.volume_tests == search_.tests;
            if (!spent) {
                ++stats.volume_tests;
                if (!volumes_[at(n)].overlaps(reached)) {
                    mark(n, NodeState::Pruned);
                    continue;
                }
            }
            if (spent || (node.level == search_.level && node.children > 0)) {
                mark(n, NodeState::Visited);
                found.stopped.push_back({grown_sphere(n), middle_cell(node), node.i0, node.j0, node.i1, node.j1});
            } else if (node.children == 0) {
                mark(n, NodeState::Leaf);
                ++stats.leaves;
                stats.candidates += append_cells(node, found.cells);
            } else {
                mark(n, NodeState::Visited);
                for (int child = 0; child < node.children; ++child) open_.push_back(node.first_child + child);
            }
        }
        stats.stopped = static_cast<std::int64_t>(found.stopped.size());
        return stats;
    }

    [[nodiscard]] bool may_touch(const Ball& ball, Real displacement) const override {
        return volumes_[0].overlaps(grown(ball, slack_ + displacement + rounding(ball)));
    }

    [[nodiscard]] Real slack() const override { return slack_; }
    [[nodiscard]] int levels() const override { return nodes_.back().level + 1; }

    void nodes_at(int level, std::span<const int> touched_cells, Outlines& outlines) const override {
        outlines.clear();
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            const QuadtreeNode& node = nodes_[n];
            const bool shown = node.level == level || (node.level < level && node.children == 0);
            if (shown) volumes_[n].outline(state_of(n, touched_cells), outlines);
        }
        for (Outlines::Sphere& sphere : outlines.spheres) sphere.radius += slack_;
    }

    [[nodiscard]] const std::vector<QuadtreeNode>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Volume>& volumes() const { return volumes_; }

private:
    static std::size_t at(int n) { return static_cast<std::size_t>(n); }

    /// Of points as far out as the ball: the exact test of a triangle is not more exact than this.
    static Real rounding(const Ball& ball) {
        return 16 * std::numeric_limits<Real>::epsilon() * (ball.centre.cwiseAbs().sum() + ball.radius);
    }

    /// Top-down: every node is fitted to all of its own particles.
    /// @par Cost O(particles * levels)
    void rebuild(const Points& x) { fits_.tree ? fits_.tree(grid_, nodes_, x, volumes_) : fit_from(0, x); }

    /// A node is followed by all that is below it, while its particles are still in the cache.
    void fit_from(int n, const Points& x) {
        const QuadtreeNode& node = nodes_[at(n)];
        volumes_[at(n)] = fits_.patch(patch_of(grid_, node, x));
        for (int child = 0; child < node.children; ++child) fit_from(node.first_child + child, x);
    }

    /// Bottom-up: leaves from particles, all others from their children.
    /// @par Cost O(particles)
    void merge(const Points& x) {
        for (const int n : leaves_) {
            const QuadtreeNode& leaf = nodes_[at(n)];
            prefetch_below(grid_, leaf, x);
            volumes_[at(n)] = fits_.patch(patch_of(grid_, leaf, x));
        }
        for (std::size_t n = nodes_.size(); n-- > 0;) {
            if (nodes_[n].children > 0) volumes_[n] = merged(nodes_[n]);
        }
    }

    Volume merged(const QuadtreeNode& node) const {
        return Volume::merge(std::span(volumes_).subspan(at(node.first_child), at(node.children)));
    }

    /// A leaf counts as moved where a particle is farther from where it was fitted than a fiftieth of the leaf's size,
    /// and until then the slack makes up for it.
    void start_refitting(const Points& x) {
        merge(x);
        copies_.take_all(grid_, nodes_, x);
        stale_.assign(nodes_.size(), false);
        Real radii = 0, leaves = 0;
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            if (nodes_[n].children > 0) continue;
            radii += volumes_[n].sphere().radius;
            leaves += 1;
        }
        slack_ = radii / leaves / 50;
    }

    /// @par Cost O(particles) to see what has moved, and a merge of that
    void refit(const Points& x) {
        for (std::size_t n = nodes_.size(); n-- > 0;) {
            const QuadtreeNode& node = nodes_[n];
            if (node.children == 0) {
                const Patch patch = patch_of(grid_, node, x);
                stale_[n] = !(copies_.displacement(n, patch) <= slack_);
                if (!stale_[n]) continue;
                volumes_[n] = fits_.patch(patch);
                copies_.take(n, patch);
            } else {
                const auto first = stale_.begin() + node.first_child;
                stale_[n] = std::find(first, first + node.children, true) != first + node.children;
                if (stale_[n]) volumes_[n] = merged(node);
            }
        }
    }

    void start_holding(const Points& x) {
        rebuild(x);
        held_ = x;
    }

    /// @par Cost O(particles), one pass
    void hold(const Points& x) { slack_ = largest_displacement(x, held_); }

    [[nodiscard]] BoundingSphere grown_sphere(int n) const {
        BoundingSphere sphere = volumes_[at(n)].sphere();
        sphere.radius += slack_;
        return sphere;
    }

    [[nodiscard]] int middle_cell(const QuadtreeNode& node) const {
        return (node.j0 + node.j1) / 2 * grid_.cell_columns() + (node.i0 + node.i1) / 2;
    }

    /// @return number of cells
    std::int64_t append_cells(const QuadtreeNode& node, std::vector<CellRun>& cells) const {
        const int columns = node.i1 - node.i0, rows = node.j1 - node.j0;
        for (int j = node.j0; j < node.j1; ++j) cells.push_back({j, node.i0, columns});
        return static_cast<std::int64_t>(columns) * rows;
    }

    /// With several balls a node shows the most that any query did with it.
    void mark(int node, NodeState state) {
        NodeState& kept = states_[at(node)];
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
    UpdateKind update_;
    SearchLimit search_;
    Fits<Volume> fits_;
    std::vector<QuadtreeNode> nodes_;
    std::vector<int> leaves_;  ///< row by row
    std::vector<Volume> volumes_;
    std::vector<NodeState> states_;  ///< what the queries since the last build did
    std::size_t leaf_rows_ = 0;      ///< of all leaves together: the most runs of cells that a query finds
    std::vector<int> open_;          ///< nodes that a query has reached
    bool built_ = false;
    Real slack_ = 0;
    LeafCopies copies_;        ///< for refit: what each leaf was fitted to
    std::vector<bool> stale_;  ///< for refit: volumes that have just changed
    Points held_;              ///< for a stale tree: what it was built from
};

}  // namespace drape
