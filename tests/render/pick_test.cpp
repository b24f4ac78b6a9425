#include <gtest/gtest.h>

#include "drape/render/camera.h"

namespace drape {
namespace {

/// A flat cloth of 1 m in the plane y = 0, from (0, 0, 0) to (1, 0, 1).
std::vector<Cloth> flat_cloth(int particles) {
    ClothParameters parameters;
    parameters.particles = {particles, particles};
    std::vector<Cloth> cloths(1);
    cloths[0].model = make_cloth_model(parameters);
    cloths[0].state = make_rest_state(parameters);
    cloths[0].previous = cloths[0].state;
    return cloths;
}

TEST(PickParticle, TakesTheNearestCornerOfTheTriangleThatIsHit) {
    const std::vector<Cloth> cloths = flat_cloth(11);
    FrameView view;
    view.cloths = cloths;
    const Pick pick = pick_particle(view, {Vec3(0.31, 1, 0.52), Vec3(0, -1, 0)});
    EXPECT_EQ(pick.particle, 5 * 11 + 3);
    EXPECT_TRUE(pick.point.isApprox(Vec3(0.31, 0, 0.52)));
}

TEST(PickParticle, HitsTheClothFromBelowToo) {
    const std::vector<Cloth> cloths = flat_cloth(11);
    FrameView view;
    view.cloths = cloths;
    EXPECT_EQ(pick_particle(view, {Vec3(0.31, -1, 0.52), Vec3(0, 1, 0)}).particle, 5 * 11 + 3);
}

TEST(PickParticle, TakesNothingBesideTheClothOrBehindTheEye) {
    const std::vector<Cloth> cloths = flat_cloth(11);
    FrameView view;
    view.cloths = cloths;
    EXPECT_EQ(pick_particle(view, {Vec3(1.2, 1, 0.5), Vec3(0, -1, 0)}).particle, -1);
    EXPECT_EQ(pick_particle(view, {Vec3(0.5, 1, 0.5), Vec3(0, 1, 0)}).particle, -1);
}

TEST(PickParticle, TakesNothingBehindABall) {
    const std::vector<Cloth> cloths = flat_cloth(11);
    const std::vector<Ball> balls{{Vec3(0.5, 0.5, 0.5), Real(0.2), Vec3::Zero()}};
    FrameView view;
    view.cloths = cloths;
    view.balls = balls;
    EXPECT_EQ(pick_particle(view, {Vec3(0.5, 2, 0.5), Vec3(0, -1, 0)}).particle, -1);
    EXPECT_NE(pick_particle(view, {Vec3(0.5, -2, 0.5), Vec3(0, 1, 0)}).particle, -1);
}

TEST(PickParticle, TakesTheClothThatIsInFront) {
    std::vector<Cloth> cloths = flat_cloth(5);
    cloths.push_back(std::move(flat_cloth(5)[0]));
    cloths[1].state.x.col(1).setConstant(Real(0.5));
    cloths[1].previous = cloths[1].state;
    FrameView view;
    view.cloths = cloths;
    EXPECT_EQ(pick_particle(view, {Vec3(0.5, 1, 0.5), Vec3(0, -1, 0)}).cloth, 1);
    EXPECT_EQ(pick_particle(view, {Vec3(0.5, -1, 0.5), Vec3(0, 1, 0)}).cloth, 0);
}

}  // namespace
}  // namespace drape
