#include "drape/bounds/bounding_sphere.h"

#include <gtest/gtest.h>

#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

using test::whole;

TEST(BoundingSphere, StandsAtTheMeanAndReachesTheFarthestParticle) {
    std::mt19937 random(5);
    for (int columns = 2; columns < 40; ++columns) {
        const Grid grid{columns, 2 + columns % 7};
        const Points x = test::random_cloth(grid, random);
        const BoundingSphere sphere = BoundingSphere::fit(whole(x, grid));
        const Eigen::RowVector3d mean = x.colwise().mean();
        EXPECT_LT((sphere.centre.transpose() - mean).norm(), 1e-14) << columns;
        EXPECT_NEAR(sphere.radius, (x.rowwise() - mean).rowwise().norm().maxCoeff(), 1e-14) << columns;
    }
}

TEST(BoundingSphere, ContainsItsParticlesAtAnyScale) {
    std::mt19937 random(6);
    for (const Real scale : {1e-6, 1.0, 1e6}) {
        for (int round = 0; round < 200; ++round) {
            const Grid grid{2 + round % 20, 2 + round % 11};
            const Points x = scale * test::random_cloth(grid, random);
            const BoundingSphere sphere = BoundingSphere::fit(whole(x, grid));
            const Real farthest = (x.rowwise() - sphere.centre.transpose()).rowwise().norm().maxCoeff();
            EXPECT_GE(sphere.radius, farthest);
            EXPECT_LE(sphere.radius, farthest * (1 + 1e-12));
        }
    }
}

TEST(BoundingSphere, SeesOnlyItsPatch) {
    const Grid grid{10, 10};
    Points x = Points::Constant(100, 3, 1e3);
    for (int j = 3; j < 6; ++j) {
        for (int i = 2; i < 7; ++i) x.row(grid.particle(i, j)) << i, j, 0;
    }
    const int first = grid.particle(2, 3);
    const BoundingSphere sphere =
        BoundingSphere::fit({x.col(0).data() + first, x.col(1).data() + first, x.col(2).data() + first, 5, 3, 10});
    EXPECT_TRUE(sphere.centre.isApprox(Vec3(4, 4, 0)));
    EXPECT_NEAR(sphere.radius, std::sqrt(5.0), 1e-14);
}

TEST(BoundingSphere, OverlapsABallThatTouchesItAndNoBallBeyond) {
    const BoundingSphere sphere{Vec3(1, 2, 3), 0.5};
    EXPECT_TRUE(sphere.overlaps({.centre = Vec3(1, 2, 4), .radius = 0.5}));
    EXPECT_FALSE(sphere.overlaps({.centre = Vec3(1, 2, 4), .radius = 0.5 - 1e-12}));
    EXPECT_TRUE(sphere.overlaps({.centre = Vec3(1, 2.1, 3), .radius = 0.01}));
}

TEST(BoundingSphere, OfOnePointIsThatPoint) {
    const Points x = Points::Constant(4, 3, 0.1);
    const BoundingSphere sphere = BoundingSphere::fit(whole(x, {2, 2}));
    EXPECT_NEAR(sphere.radius, 0, 1e-15);
}

}  // namespace
}  // namespace drape
