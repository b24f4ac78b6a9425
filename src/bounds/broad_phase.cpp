#include "drape/bounds/broad_phase.h"

#include <array>
#include <numeric>

#include "drape/base/assert.h"
#include "drape/bounds/aabb.h"
#include "drape/bounds/bounding_sphere.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/bounds/kdop.h"
#include "drape/bounds/obb.h"

namespace drape {
namespace {

/// The oracle: no hierarchy, every cell is a candidate.
class BruteForce final : public BroadPhase {
public:
    explicit BruteForce(const Grid& grid) : cells_(grid.cells()) {}

    void build(const Points& /*x*/) override {}

    TraversalStats query(const Ball& /*ball*/, Candidates& found) override {
        found.cells.resize(static_cast<std::size_t>(cells_));
        std::iota(found.cells.begin(), found.cells.end(), 0);
        found.stopped.clear();
        return {.candidates = cells_};
    }

    [[nodiscard]] bool may_touch(const Ball& /*ball*/, Real /*displacement*/) const override { return true; }
    [[nodiscard]] Real slack() const override { return 0; }
    [[nodiscard]] int levels() const override { return 0; }
    void nodes_at(int /*level*/, std::span<const int> /*touched*/, Outlines& nodes) const override { nodes.clear(); }

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
    stopped += other.stopped;
    return *this;
}

std::unique_ptr<BroadPhase> make_broad_phase(const BroadPhaseParameters& parameters, const Grid& grid) {
    switch (parameters.volume) {
        case VolumeKind::Sphere:
            return std::make_unique<ClothQuadtree<BoundingSphere>>(grid, parameters);
        case VolumeKind::Aabb:
            return std::make_unique<ClothQuadtree<Aabb>>(grid, parameters);
        case VolumeKind::Kdop6:
            return std::make_unique<ClothQuadtree<KDop<6>>>(grid, parameters);
        case VolumeKind::Kdop14:
            return std::make_unique<ClothQuadtree<KDop<14>>>(grid, parameters);
        case VolumeKind::Kdop18:
            return std::make_unique<ClothQuadtree<KDop<18>>>(grid, parameters);
        case VolumeKind::Kdop26:
            return std::make_unique<ClothQuadtree<KDop<26>>>(grid, parameters);
        case VolumeKind::Obb:
            return std::make_unique<ClothQuadtree<Obb>>(grid, parameters);
        case VolumeKind::Brute:
            return std::make_unique<BruteForce>(grid);
    }
    DRAPE_ASSERT(false && "every kind has its hierarchy");
    return nullptr;
}

std::span<const std::string> volume_names() {
    static const std::array<std::string, 8> names{"sphere", "aabb",   "kdop6", "kdop14",
                                                  "kdop18", "kdop26", "obb",   "brute"};
    return names;
}

std::span<const std::string> update_names() {
    static const std::array<std::string, 4> names{"rebuild", "merge", "refit", "none"};
    return names;
}

}  // namespace drape
