// Every fit of the spheres, every update and leaf size: a query gives the triangles that brute force gives.

#include <gtest/gtest.h>

#include <algorithm>

#include "drape/bounds/cloth_quadtree.h"
#include "drape/contact/detection.h"
#include "support/cloths.h"

namespace drape {
namespace {

std::vector<int> touched(BroadPhase& broad_phase, const Grid& grid, const Points& x, const Ball& ball) {
    Candidates found;
    std::vector<int> triangles;
    broad_phase.query(ball, found);
    find_touched_triangles(grid, x, ball, 0, found.cells, triangles, Kernels::Vector);
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

struct FitTally {
    int configurations = 0, disagreements = 0, touching = 0;
};

/// Moves a cloth at random, and lets balls touch the farthest particles of nodes from outside, by a millionth of their
/// radius.
FitTally compare_on_moving_cloth(BroadPhase& tree, const Grid& grid, int leaf_cells,
                                 BoundingSphere (*fit)(const Patch&)) {
    std::mt19937 random(static_cast<unsigned>(grid.nx * 100 + leaf_cells));
    std::uniform_real_distribution<Real> unit(-1, 1);
    const std::vector<QuadtreeNode> nodes = make_quadtree_nodes(grid, leaf_cells);
    const auto brute = make_broad_phase({.volume = VolumeKind::Brute}, grid);
    Points x = test::random_cloth(grid, random);
    FitTally tally;
    for (int frame = 0; frame < 12; ++frame) {
        for (Real& coordinate : x.reshaped()) coordinate += Real(0.01) * unit(random);
        tree.build(x);
        for (int round = 0; round < 30; ++round) {
            const Patch patch = patch_of(grid, nodes[random() % nodes.size()], x);
            const Vec3 centre = fit(patch).centre;
            Vec3 farthest = centre;
            for (int j = 0; j < patch.rows; ++j) {
                for (int i = 0; i < patch.columns; ++i) {
                    const Vec3 p = patch.at(i, j);
                    if ((p - centre).norm() > (farthest - centre).norm()) farthest = p;
                }
            }
            const Real radius = Real(0.02) * std::exp(2 * (1 + unit(random)));
            const Vec3 outward = (farthest - centre).normalized();
            const Ball ball{.centre = farthest + outward * (radius * (1 - 1e-6)), .radius = radius};
            const std::vector<int> expected = touched(*brute, grid, x, ball);
            ++tally.configurations;
            tally.touching += !expected.empty();
            tally.disagreements += touched(tree, grid, x, ball) != expected;
        }
    }
    return tally;
}

TEST(SphereFitQuery, GivesWhatBruteForceGivesWithEveryFitUpdateAndLeafSize) {
    int touching = 0, configurations = 0;
    for (std::size_t f = 0; f < names_of<SphereFit>().size(); ++f) {
        for (std::size_t u = 0; u < names_of<UpdateKind>().size(); ++u) {
            for (const int leaf_cells : {1, 2, 4, 7}) {
                for (const Grid& grid : {Grid{14, 9}, Grid{2, 30}}) {
                    const auto fit = static_cast<SphereFit>(f);
                    const auto tree = make_broad_phase(
                        {.update = static_cast<UpdateKind>(u), .leaf_cells = leaf_cells, .sphere_fit = fit}, grid);
                    const FitTally tally =
                        compare_on_moving_cloth(*tree, grid, leaf_cells, sphere_fit_of(fit, Kernels::Vector));
                    EXPECT_EQ(tally.disagreements, 0)
                        << names_of<SphereFit>()[f] << ", " << names_of<UpdateKind>()[u] << ", leaf " << leaf_cells;
                    touching += tally.touching;
                    configurations += tally.configurations;
                }
            }
        }
    }
    EXPECT_EQ(touching, configurations);
}

/// The planted fault: the smallest spheres, and one percent less.
BoundingSphere fit_too_small_sphere(const Patch& patch) {
    BoundingSphere sphere = fit_smallest_sphere(patch);
    sphere.radius *= Real(0.99);
    return sphere;
}

TEST(SphereFitQuery, IsCaughtWhenTheSmallestSpheresAreOnePercentTooSmall) {
    const Grid grid{14, 9};
    ClothQuadtree<BoundingSphere> tree(grid, {.leaf_cells = 2}, {.patch = fit_too_small_sphere});
    EXPECT_GT(compare_on_moving_cloth(tree, grid, 2, fit_smallest_sphere).disagreements, 20);
}

}  // namespace
}  // namespace drape
