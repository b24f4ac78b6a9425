#include "drape/bounds/aabb.h"

#include <gtest/gtest.h>

namespace drape {
namespace {

TEST(Aabb, OverlapsABallThatTouchesAFaceAnEdgeOrACornerAndNoBallBeyond) {
    const Aabb box{Vec3(0, 0, 0), Vec3(1, 2, 3)};
    for (const Vec3& off : {Vec3(0.5, 0, 0), Vec3(0, -0.5, 0), Vec3(0.3, 0.4, 0), Vec3(-0.2, -0.3, 0.6)}) {
        Vec3 from;
        for (int k = 0; k < 3; ++k) from[k] = off[k] > 0 ? box.high[k] : box.low[k];
        EXPECT_TRUE(box.overlaps({.centre = from + off, .radius = off.norm() * (1 + 1e-15)}));
        EXPECT_FALSE(box.overlaps({.centre = from + off, .radius = off.norm() * (1 - 1e-12)}));
    }
    EXPECT_TRUE(box.overlaps({.centre = Vec3(0.5, 1, 1), .radius = 0}));
}

}  // namespace
}  // namespace drape
