#pragma once

#include "drape/bounds/cloth_quadtree.h"

namespace drape {

/// A quadtree whose traversal ends at a level, or after a number of tests, and hands on the nodes it has ended at.
/// @cite hubbard1996
template <BoundingVolume Volume>
class LimitedQuadtree final : public ClothQuadtree<Volume> {
public:
    LimitedQuadtree(const Grid& grid, const BroadPhaseParameters& parameters)
        : ClothQuadtree<Volume>(grid, parameters), limit_(parameters.search), cell_columns_(grid.cell_columns()) {
        queue_.reserve(this->nodes().size());
    }

    [[nodiscard]] std::unique_ptr<BroadPhase> clone() const override {
        return std::make_unique<LimitedQuadtree>(*this);
    }

    /// Level by level, so that what ends it has seen all of the cloth alike.
    TraversalStats query(const Ball& ball, Candidates& found) override {
        this->begin_query(found);
        found.stopped.reserve(this->nodes().size());
        TraversalStats stats{.nodes = static_cast<std::int64_t>(this->nodes().size())};
        const Ball grown_ball = this->grown_by_slack(ball);
        queue_.assign(1, 0);
        for (std::size_t next = 0; next < queue_.size(); ++next) {
            const int n = queue_[next];
            const QuadtreeNode& node = this->nodes()[this->at(n)];
            ++stats.visited;
            const bool spent = limit_.tests > 0 && stats.volume_tests == limit_.tests;
            if (!spent) ++stats.volume_tests;
            if (!spent && !this->volumes()[this->at(n)].overlaps(grown_ball)) {
                this->mark(n, NodeVisit::Pruned);
                ++stats.pruned;
            } else if (spent || (node.level == limit_.level && node.children > 0)) {
                this->mark(n, NodeVisit::Entered);
                found.stopped.push_back(stop_at(n));
            } else if (node.children == 0) {
                this->mark(n, NodeVisit::Leaf);
                this->take_leaf(node, found, stats);
            } else {
                this->mark(n, NodeVisit::Entered);
                for (int child = 0; child < node.children; ++child) queue_.push_back(node.first_child + child);
            }
        }
        stats.stopped = static_cast<std::int64_t>(found.stopped.size());
        return stats;
    }

private:
    [[nodiscard]] StoppedNode stop_at(int n) const {
        const QuadtreeNode& node = this->nodes()[this->at(n)];
        BoundingSphere sphere = this->volumes()[this->at(n)].sphere();
        sphere.radius += this->slack();
        const int middle = (node.j0 + node.j1) / 2 * cell_columns_ + (node.i0 + node.i1) / 2;
        return {node, sphere, middle};
    }

    SearchLimit limit_;
    int cell_columns_;
    std::vector<int> queue_;  ///< nodes that a query visits
};

}  // namespace drape
