#include "drape/bounds/broad_phase.h"

#include <array>

#include "drape/base/assert.h"
#include "drape/bounds/aabb.h"
#include "drape/bounds/centroid_tree.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/bounds/kdop.h"
#include "drape/bounds/obb.h"

namespace drape {
namespace {

/// The oracle: no hierarchy, every cell is a candidate.
class BruteForce final : public BroadPhase {
public:
    explicit BruteForce(const Grid& grid) : grid_(grid) {}

    void build(const Points& /*x*/) override {}

    TraversalStats query(const Ball& /*ball*/, Candidates& found) override {
        list_all_cells(grid_, found.cells);
        found.stopped.clear();
        return {.candidates = grid_.cells()};
    }

    [[nodiscard]] bool may_touch(const Ball& /*ball*/, Real /*displacement*/) const override { return true; }
    [[nodiscard]] Real slack() const override { return 0; }
    [[nodiscard]] int levels() const override { return 0; }
    void nodes_at(int /*level*/, std::span<const int> /*touched*/, Outlines& nodes) const override { nodes.clear(); }

private:
    Grid grid_;
};

/// Centroid spheres have a way to fit all levels at once.
Fits<BoundingSphere> fits_of(SphereFit kind) {
    return {.patch = sphere_fit_of(kind), .tree = kind == SphereFit::Centroid ? fit_centroid_tree : nullptr};
}

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

void list_all_cells(const Grid& grid, std::vector<CellRun>& cells) {
    cells.clear();
    for (int j = 0; j < grid.cell_rows(); ++j) cells.push_back({j, 0, grid.cell_columns()});
}

std::unique_ptr<BroadPhase> make_broad_phase(const BroadPhaseParameters& parameters, const Grid& grid) {
    switch (parameters.volume) {
        case VolumeKind::Sphere:
            return std::make_unique<ClothQuadtree<BoundingSphere>>(grid, parameters, fits_of(parameters.sphere_fit));
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

}  // namespace drape
