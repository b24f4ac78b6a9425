// The ground's contacts through the hierarchy are those of the pass over all heights, in the same order.

#include <gtest/gtest.h>

#include "drape/bounds/cloth_quadtree.h"
#include "drape/contact/detection.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

template <class V>
class GroundQuery : public ::testing::Test {};

TYPED_TEST_SUITE(GroundQuery, test::UnlikeVolumes, test::VolumeNames);

struct GroundSeen {
    int touching = 0;
    std::int64_t pruned = 0;
};

/// Compares a tree about x with the pass, at heights between the cloth's lowest and highest particles and beyond.
void compare_with_pass(const Grid& grid, const BroadPhase& tree, const Points& x, GroundSeen& seen) {
    constexpr Real thickness = Real(0.002);
    std::vector<ContactRow> expected, found;
    std::vector<CellRun> all;
    list_all_cells(grid, all);
    Candidates low;
    const Real bottom = x.col(1).minCoeff(), span = x.col(1).maxCoeff() - bottom;
    for (const Real part : {-0.1, 0.0, 1e-9, 0.05, 0.3, 0.9, 1.1}) {
        const Real height = bottom + part * span - thickness;
        expected.clear(), found.clear();
        find_ground_contacts({grid, x, x}, height, {0, thickness}, all, expected);
        seen.pruned += tree.query_near([&](const Vec3& p) { return p.y() - height; }, thickness, low).pruned;
        std::ranges::sort(low.cells);
        find_ground_contacts({grid, x, x}, height, {0, thickness}, low.cells, found);
        ASSERT_EQ(found.size(), expected.size()) << part;
        for (std::size_t c = 0; c < found.size(); ++c) {
            ASSERT_EQ(found[c].particles[0].particle, expected[c].particles[0].particle);
            ASSERT_EQ(found[c].depth, expected[c].depth);
        }
        if (!found.empty()) ++seen.touching;
    }
}

TYPED_TEST(GroundQuery, FindsTheContactsOfAPassOverAllHeights) {
    std::mt19937 random(5);
    GroundSeen seen;
    for (const Grid& grid : {Grid{2, 2}, Grid{9, 5}, Grid{31, 17}}) {
        for (const UpdateKind update :
             {UpdateKind::Rebuild, UpdateKind::Merge, UpdateKind::Insertion, UpdateKind::Refit, UpdateKind::None}) {
            ClothQuadtree<TypeParam> tree(grid, {.update = update, .leaf_cells = 2});
            Points x = test::random_cloth(grid, random);
            for (int step = 0; step < 6; ++step) {
                tree.build(x);
                compare_with_pass(grid, tree, x, seen);
                x = (1 - Real(0.1)) * x + Real(0.1) * test::random_cloth(grid, random);
            }
        }
    }
    EXPECT_GT(seen.touching, 300);
    EXPECT_GT(seen.pruned, 1000);
}

}  // namespace
}  // namespace drape
