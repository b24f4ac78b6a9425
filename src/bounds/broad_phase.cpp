#include "drape/bounds/broad_phase.h"

#include <array>
#include <numeric>

#include "drape/base/assert.h"
#include "drape/bounds/bounding_sphere.h"
#include "drape/bounds/cloth_quadtree.h"

namespace drape {
namespace {

/// The oracle: no hierarchy, every cell is a candidate.
class BruteForce final : public BroadPhase {
public:
    explicit BruteForce(const Grid& grid) : cells_(grid.cells()) {}

    void build(const Points& /*x*/, Real /*thickness*/) override {}

    TraversalStats query(const Ball& /*ball*/, std::vector<int>& cells) override {
        cells.resize(static_cast<std::size_t>(cells_));
        std::iota(cells.begin(), cells.end(), 0);
        return {.candidates = cells_};
    }

    [[nodiscard]] int levels() const override { return 0; }
    void nodes_at(int /*level*/, std::span<const int> /*touched*/, std::vector<NodeView>& nodes) const override {
        nodes.clear();
    }

private:
    int cells_;
};

}  // namespace

TraversalStats& TraversalStats::operator+=(const TraversalStats& other) {
    nodes += other.nodes;
    visited += other.visited;
    volume_tests += other.volume_tests;
    leaves += other.leaves;
    candidates += other.candidates;
    return *this;
}

std::unique_ptr<BroadPhase> make_broad_phase(const BroadPhaseParameters& parameters, const Grid& grid) {
    switch (parameters.volume) {
        case VolumeKind::Sphere:
            return std::make_unique<ClothQuadtree<BoundingSphere>>(grid, parameters.leaf_cells);
        case VolumeKind::Brute:
            return std::make_unique<BruteForce>(grid);
    }
    DRAPE_ASSERT(false && "every kind has its hierarchy");
    return nullptr;
}

std::span<const std::string> volume_names() {
    static const std::array<std::string, 2> names{"sphere", "brute"};
    return names;
}

std::span<const std::string> update_names() {
    static const std::array<std::string, 1> names{"rebuild"};
    return names;
}

}  // namespace drape
