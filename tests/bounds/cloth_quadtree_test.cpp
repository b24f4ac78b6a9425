#include "drape/bounds/cloth_quadtree.h"

#include <gtest/gtest.h>

#include "drape/bounds/bounding_sphere.h"
#include "support/allocations.h"
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
    EXPECT_EQ(found.cells.size(), 4u) << "a run for each of its rows";

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

TEST(BroadPhases, AllocateNothingAfterTheFirstFrame) {
    std::mt19937 random(8);
    const Grid grid{31, 17};
    const Points x[] = {test::random_cloth(grid, random), test::random_cloth(grid, random)};
    for (const VolumeKind volume : values_of<VolumeKind>()) {
        for (const UpdateKind update : values_of<UpdateKind>()) {
            const auto broad_phase = make_broad_phase({.volume = volume, .update = update}, grid);
            Candidates found;
            broad_phase->build(x[0]);
            broad_phase->query({.centre = Vec3::Zero(), .radius = 0.1}, found);
            const auto before = test::allocations();
            for (const Points& moved : x) {
                broad_phase->build(moved);
                broad_phase->query({.centre = Vec3::Zero(), .radius = 9}, found);
            }
            EXPECT_EQ(test::allocations(), before) << name_of(volume) << ", " << name_of(update);
        }
    }
}

}  // namespace
}  // namespace drape
