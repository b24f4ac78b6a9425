#include <gtest/gtest.h>

#include "resting_cloth.h"

namespace drape {
namespace {

using test::RestingCloth;

// Of 1 m in the plane y = 0, from (0, 0, 0) to (1, 0, 1)
TEST(PickParticle, TakesTheNearestCornerOfTheTriangleThatIsHitAndNothingBesideOrBehind) {
    const RestingCloth cloth({11, 11});
    FrameView view;
    view.cloths = {&cloth.view, 1};
    const Vec3 down(0, -1, 0), up(0, 1, 0);
    const Pick pick = pick_particle(view, {Vec3(0.31, 1, 0.52), down});
    EXPECT_EQ(pick.particle, 5 * 11 + 3);
    EXPECT_TRUE(pick.point.isApprox(Vec3(0.31, 0, 0.52)));
    EXPECT_EQ(pick_particle(view, {Vec3(0.31, -1, 0.52), up}).particle, 5 * 11 + 3) << "from below";
    EXPECT_EQ(pick_particle(view, {Vec3(1.2, 1, 0.5), down}).particle, -1) << "beside the cloth";
    EXPECT_EQ(pick_particle(view, {Vec3(0.5, 1, 0.5), up}).particle, -1) << "behind the eye";
    const std::vector<Ball> balls{{Vec3(0.5, 0.5, 0.5), Real(0.2), Vec3::Zero()}};
    view.balls = balls;
    const Pick at_ball = pick_particle(view, {Vec3(0.6, 2, 0.5), down});
    EXPECT_EQ(at_ball.particle, -1) << "behind a ball";
    EXPECT_EQ(at_ball.ball, 0);
    EXPECT_TRUE((at_ball.point + at_ball.to_centre).isApprox(balls[0].centre));
    const Pick at_cloth = pick_particle(view, {Vec3(0.5, -2, 0.5), up});
    EXPECT_NE(at_cloth.particle, -1);
    EXPECT_EQ(at_cloth.ball, -1);
}

TEST(PickParticle, TakesTheClothThatIsInFront) {
    const RestingCloth low({5, 5});
    RestingCloth high({5, 5});
    high.x.col(1).setConstant(Real(0.5));
    const std::vector<ClothView> cloths{low.view, high.view};
    FrameView view;
    view.cloths = cloths;
    EXPECT_EQ(pick_particle(view, {Vec3(0.5, 1, 0.5), Vec3(0, -1, 0)}).cloth, 1);
    EXPECT_EQ(pick_particle(view, {Vec3(0.5, -1, 0.5), Vec3(0, 1, 0)}).cloth, 0);
}

}  // namespace
}  // namespace drape
