// A ball's pattern shows how it is turned.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "drawn_scene.h"

namespace drape::test {
namespace {

using Quaternion = Eigen::Quaternion<Real>;

constexpr int picture_side = 160;

/// One ball in the middle of the picture.
struct TurningBall : DrawnScene, testing::Test {
    TurningBall() : DrawnScene("trampoline"), ball(simulation.balls()[0]) {
        settings.view.target = ball.centre;
        settings.view.eye = ball.centre + Vec3(Real(0.5), Real(0.6), Real(0.7));
        renderer.resize(picture_side, picture_side);
    }

    Image draw(const Quaternion& before, const Quaternion& now, Real blend) {
        Ball previous = ball, present = ball;
        previous.orientation = before;
        present.orientation = now;
        view.balls = {&present, 1};
        view.previous_balls = {&previous, 1};
        view.blend = blend;
        renderer.draw(view, Camera(settings.view), {});
        return renderer.read_back();
    }

    GlContext context = make_context();
    Renderer renderer;
    Ball ball;
};

int middle_of(const Image& image) { return image.pixel(picture_side / 2, picture_side / 2)[1]; }

TEST_F(TurningBall, ShowsThePartOfItsPatternThatFacesTheEye) {
    const Vec3 to_eye = (settings.view.eye - ball.centre).normalized();
    std::mt19937 random(5);
    std::normal_distribution<Real> normal;
    std::vector<int> light, dark;
    for (int i = 0; i < 60; ++i) {
        const Quaternion turn = Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
        const Vec3 own = turn.conjugate() * to_eye;
        if (std::abs(own.x() * own.z()) < 0.05 || std::abs(own.y()) < 0.15) continue;  // near an edge
        (own.x() * own.z() > 0 ? dark : light).push_back(middle_of(draw(turn, turn, 1)));
    }
    ASSERT_GT(light.size(), 10U);
    ASSERT_GT(dark.size(), 10U);
    EXPECT_GT(*std::ranges::min_element(light), *std::ranges::max_element(dark) + 10);
}

TEST_F(TurningBall, IsDrawnBetweenItsLastTwoOrientations) {
    const Vec3 axis = Vec3(1, 2, -1).normalized();
    const auto turned = [&](Real angle) { return Quaternion(Eigen::AngleAxis<Real>(angle, axis)); };
    const Image half = draw(turned(Real(0.2)), turned(Real(1.0)), Real(0.5));
    EXPECT_TRUE(half.rgb == draw(turned(Real(0.6)), turned(Real(0.6)), 1).rgb);
    EXPECT_FALSE(half.rgb == draw(turned(1), turned(1), 1).rgb);
}

}  // namespace
}  // namespace drape::test
