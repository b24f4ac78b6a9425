// The cone test says that a patch keeps away from itself only where that is so.

#include "drape/bounds/fold_test.h"

#include <gtest/gtest.h>

#include "drape/contact/near_pairs.h"
#include "support/cloths.h"

namespace drape {
namespace {

constexpr Real spacing = Real(0.1);

/// Rolled about an axis along z: a sheet of the given curvature [1/m], waved a little.
Points rolled(const Grid& grid, Real curvature, Real wave) {
    Points x(grid.particles(), 3);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const Real angle = curvature * spacing * static_cast<Real>(i), z = spacing * static_cast<Real>(j);
            const Real radius = 1 / curvature + wave * std::sin(9 * z);
            x.row(grid.particle(i, j)) << radius * std::sin(angle), radius * std::cos(angle), z;
        }
    }
    return x;
}

/// How many pairs of features in two rectangles of cells, or in one, are within what their particles reach [m].
std::size_t pairs_in(const Grid& grid, const Points& x, const CellRange& first, const CellRange& second,
                     std::span<const Real> reaches) {
    CellBoxes boxes;
    boxes.build(grid, x, reaches);
    std::vector<NearPair> pairs;
    const BoxedCloth cloth{.cloth = {0, grid, x}, .boxes = boxes, .reaches = reaches};
    const LeafPair leaves{first, second};
    find_near_pairs(cloth, cloth, {&leaves, 1}, pairs);
    return pairs.size();
}

/// One of two leaves that touch at a corner is flat, and so is the other: the fold is in the two beside them.
TEST(FoldTest, LooksAtAllFourNodesThatMeetAtACorner) {
    const Grid grid{5, 5};
    const auto nodes = make_quadtree_nodes(grid, 2);
    ASSERT_EQ(nodes.size(), 5U);
    Points x = rolled(grid, Real(1e-3), 0);
    FoldTest folds(grid, spacing, spacing, 2);
    folds.build(x);
    EXPECT_TRUE(folds.nodes_are_separated(1, 4, Real(0.01)));
    EXPECT_TRUE(folds.nodes_are_separated(2, 3, Real(0.01)));
    // In each of them alone
    for (const auto& [i, j] : {std::pair(0, 0), {4, 0}, {0, 4}, {4, 4}}) {
        Points folded = x;
        folded.row(grid.particle(i, j)) = x.row(grid.particle(2, 2));
        folds.build(folded);
        EXPECT_FALSE(folds.nodes_are_separated(1, 4, Real(0))) << i << ", " << j;
        EXPECT_FALSE(folds.nodes_are_separated(2, 3, Real(0))) << i << ", " << j;
        EXPECT_EQ(folds.nodes_are_separated(3, 4, Real(0.01)), j == 0);
    }
}

TEST(FoldTest, AsksForNoMoreThanParticlesReachAndNoLess) {
    const Grid grid{17, 13};
    const auto nodes = make_quadtree_nodes(grid, 3);
    std::mt19937 random(8);
    std::uniform_real_distribution<Real> unit(0, 1);
    int proved = 0, by_reach_alone = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Points x = rolled(grid, Real(0.5) + 8 * unit(random), Real(0.05) * unit(random));
        x.col(2) *= Real(0.3) + unit(random);
        // Some particles reach far, and most do not
        std::vector<Real> reaches(static_cast<std::size_t>(grid.particles()));
        for (Real& reach : reaches) reach = unit(random) < Real(0.01) ? Real(0.1) : Real(0.03) * unit(random);
        FoldTest folds(grid, spacing, spacing, 3), without(grid, spacing, spacing, 3);
        folds.build(x, reaches);
        without.build(x);
        const Real largest = 2 * std::ranges::max(reaches);
        for (int n = 0; n < static_cast<int>(nodes.size()); ++n) {
            const QuadtreeNode& node = nodes[static_cast<std::size_t>(n)];
            for (int m = n; m < static_cast<int>(nodes.size()); ++m) {
                const auto apart = [&](const FoldTest& test) {
                    return m == n ? test.node_is_separated(n, largest) : test.nodes_are_separated(n, m, largest);
                };
                if (!apart(folds)) continue;
                ++proved;
                by_reach_alone += !apart(without);
                ASSERT_EQ(pairs_in(grid, x, node, nodes[static_cast<std::size_t>(m)], reaches), 0U);
            }
        }
    }
    EXPECT_GT(proved, 300);
    EXPECT_GT(by_reach_alone, 300);
}

}  // namespace
}  // namespace drape
