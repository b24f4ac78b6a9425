#include "drape/bounds/broad_phase.h"

#include "drape/bounds/cloth_quadtree.h"

namespace drape {
namespace {

/// The oracle: no hierarchy, every cell is a candidate.
class BruteForce final : public BroadPhase {
public:
    explicit BruteForce(const Grid& grid) : grid_(grid) {}

    [[nodiscard]] std::unique_ptr<BroadPhase> clone() const override { return std::make_unique<BruteForce>(*this); }

    void build(const Points& /*x*/) override {}
    TraversalStats query(const Ball& /*ball*/, Candidates& found) override { return all(found); }
    TraversalStats query(const BroadPhase& other, Real /*margin*/, const FoldTest* /*folds*/,
                         std::vector<LeafPair>& pairs) override {
        const Grid& other_grid = static_cast<const BruteForce&>(other).grid_;
        pairs.assign(1, {all_cells(grid_), all_cells(other_grid)});
        return {.candidates = pairs_of_cells(grid_.cells(), other_grid.cells(), &other == this)};
    }
    TraversalStats query_near(const DistanceFunction& /*distance*/, Real /*margin*/, Candidates& found) override {
        return all(found);
    }
    [[nodiscard]] Real slack() const override { return 0; }
    [[nodiscard]] int levels() const override { return 0; }
    void nodes_at(int /*level*/, std::vector<NodeView>& nodes) const override { nodes.clear(); }

private:
    TraversalStats all(Candidates& found) const {
        found.cells.assign(1, all_cells(grid_));
        found.stopped.clear();
        return {.candidates = grid_.cells()};
    }

    Grid grid_;
};

}  // namespace

TraversalStats& TraversalStats::operator+=(const TraversalStats& other) {
    using Stats = TraversalStats;
    for (const auto count : {&Stats::nodes, &Stats::visited, &Stats::volume_tests, &Stats::pruned, &Stats::leaves,
                             &Stats::candidates, &Stats::stopped})
        this->*count += other.*count;
    return *this;
}

std::unique_ptr<BroadPhase> make_broad_phase(const BroadPhaseParameters& parameters, const Grid& grid) {
    if (parameters.volume == VolumeKind::Brute) return std::make_unique<BruteForce>(grid);
    return with_volume(parameters.volume, [&]<class Volume>(std::type_identity<Volume>) -> std::unique_ptr<BroadPhase> {
        return std::make_unique<ClothQuadtree<Volume>>(grid, parameters);
    });
}

}  // namespace drape
