#include "drape/bounds/cloth_quadtree.h"

#include <gtest/gtest.h>

#include "drape/bounds/bounding_sphere.h"
#include "drape/bounds/node_view.h"
#include "support/cloths.h"

namespace drape {
namespace {

/// A square of side 1 m at rest.
Points flat_sheet(const Grid& grid) {
    ClothParameters parameters;
    parameters.particles = grid;
    return make_rest_state(parameters).x;
}

TEST(SphereQuadtree, CountsAndShowsWhatItDoes) {
    const Grid grid{9, 9};
    const Points x = flat_sheet(grid);
    ClothQuadtree<BoundingSphere> tree(grid, {.leaf_cells = 4});
    tree.build(x);
    Candidates found;

    // Beyond everything: the root alone is tested
    TraversalStats stats = tree.query({.centre = Vec3(0, 9, 0), .radius = 1}, found);
    EXPECT_EQ(stats.nodes, 5);
    EXPECT_EQ(stats.visited, 1);
    EXPECT_EQ(stats.volume_tests, 1);
    EXPECT_EQ(stats.leaves, 0);
    EXPECT_EQ(stats.candidates, 0);

    // At the corner of the first quarter: one leaf of four
    stats = tree.query({.centre = Vec3(0, 0, 0), .radius = 0.05}, found);
    EXPECT_EQ(stats.visited, 5);
    EXPECT_EQ(stats.leaves, 1);
    EXPECT_EQ(stats.candidates, 16);
    EXPECT_EQ(found.cells.size(), 4u) << "a range for each of its rows";

    std::vector<NodeView> views;
    EXPECT_EQ(tree.levels(), 2);
    tree.nodes_at(0, views);
    ASSERT_EQ(views.size(), 1u);
    EXPECT_EQ(views[0].visit, NodeVisit::Entered);
    tree.nodes_at(1, views);
    ASSERT_EQ(views.size(), 4u);
    EXPECT_EQ(views[0].visit, NodeVisit::Leaf);
    EXPECT_EQ(views[3].visit, NodeVisit::Pruned);
    EXPECT_TRUE(std::get<BoundingSphere>(views[0].volume).centre.isApprox(Vec3(0.25, 0, 0.25)));

    // Around everything
    stats = tree.query({.centre = Vec3(0, 0, 0), .radius = 9}, found);
    EXPECT_EQ(stats.leaves, 4);
    EXPECT_EQ(stats.candidates, 64);
}

TEST(RefitNodes, GivesEachLevelTheVolumesOfABuild) {
    const Grid grid{23, 17};
    std::mt19937 random(23);
    const Points before = test::random_cloth(grid, random), now = test::random_cloth(grid, random);
    for (const VolumeKind volume : values_of<VolumeKind>()) {
        const BroadPhaseParameters parameters{.volume = volume, .leaf_cells = 3};
        const auto built = make_broad_phase(parameters, grid), old = make_broad_phase(parameters, grid);
        built->build(now);
        old->build(before);
        for (int level = 0; level < built->levels(); ++level) {
            std::vector<NodeView> nodes, refitted;
            built->nodes_at(level, nodes);
            old->nodes_at(level, refitted);
            refit_nodes(parameters, grid, now, refitted);
            const auto sphere_of = [](const NodeView& node) {
                return std::visit([](const auto& fitted) { return fitted.sphere(); }, node.volume);
            };
            ASSERT_EQ(refitted.size(), nodes.size());
            for (std::size_t n = 0; n < nodes.size(); ++n) {
                const BoundingSphere expected = sphere_of(nodes[n]), found = sphere_of(refitted[n]);
                const std::string which = name_of(volume) + ", level " + std::to_string(level);
                EXPECT_NEAR((found.centre - expected.centre).norm(), 0, 1e-9) << which;
                EXPECT_NEAR(found.radius, expected.radius, 1e-9) << which;
            }
        }
    }
}

}  // namespace
}  // namespace drape
