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

}  // namespace
}  // namespace drape
