#pragma once

#include <memory>
#include <vector>

#include "drape/bounds/fold_test.h"
#include "drape/contact/near_pairs.h"

namespace drape::test {

/// A cloth of 1 m with a hierarchy, the cone test and the boxes of its cells, built about positions.
struct SearchedCloth {
    SearchedCloth(int its_number, const Grid& its_grid, const BroadPhaseParameters& parameters)
        : number(its_number),
          grid(its_grid),
          tree(make_broad_phase(parameters, grid)),
          folds(grid, Real(1) / static_cast<Real>(grid.nx - 1), Real(1) / static_cast<Real>(grid.ny - 1),
                parameters.leaf_cells) {}

    void build(const Points& positions) {
        x = positions;
        tree->build(x);
        folds.build(x);
    }

    [[nodiscard]] Vec3 at(int particle) const { return x.row(particle).transpose(); }

    /// @param margin by which features may be apart: each reaches half of it
    [[nodiscard]] BoxedCloth boxed(Real margin) {
        reaches.assign(static_cast<std::size_t>(grid.particles()), margin / 2);
        boxes.build(grid, x, reaches);
        return {{number, grid, x}, boxes, reaches};
    }

    int number;
    Grid grid;
    std::unique_ptr<BroadPhase> tree;
    FoldTest folds;
    CellBoxes boxes;
    std::vector<Real> reaches;
    std::vector<LeafPair> leaves;
    Points x;
};

/// Pairs of features that are nearer than a margin: of two cloths, or of one with itself.
inline std::vector<NearPair> pairs_within(SearchedCloth& first, SearchedCloth& second, Real margin) {
    const FoldTest* folds = &first == &second ? &first.folds : nullptr;
    first.tree->query(*second.tree, margin, folds, first.leaves);
    std::vector<NearPair> pairs;
    find_near_pairs(first.boxed(margin), second.boxed(margin), first.leaves, pairs);
    return pairs;
}

}  // namespace drape::test
