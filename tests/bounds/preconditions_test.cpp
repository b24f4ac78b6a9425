// What a caller must hold to is checked where assertions are on, as they are in the tests.

#include "drape/base/real.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/bounds/kdop.h"
#include "drape/bounds/obb.h"
#include "support/expect_assertion.h"

namespace drape {
namespace {

template <class Volume>
class VolumeDeathTest : public ::testing::Test {};

using Volumes = ::testing::Types<BoundingSphere, Aabb, KDop<14>, Obb>;
TYPED_TEST_SUITE(VolumeDeathTest, Volumes);

TYPED_TEST(VolumeDeathTest, RefusesToMergeNothing) {
    EXPECT_ASSERTION(static_cast<void>(TypeParam::merge({})), "children.empty");
}

TYPED_TEST(VolumeDeathTest, RefusesAQueryBeforeTheFirstBuild) {
    ClothQuadtree<TypeParam> tree(Grid{4, 4});
    Candidates found;
    EXPECT_ASSERTION(static_cast<void>(tree.query(Ball{}, found)), "built_");
}

TYPED_TEST(VolumeDeathTest, RefusesPositionsOfAnotherGrid) {
    ClothQuadtree<TypeParam> tree(Grid{4, 4});
    EXPECT_ASSERTION(tree.build(Points::Zero(15, 3)), "x.rows");
}

}  // namespace
}  // namespace drape
