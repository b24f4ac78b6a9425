// How finely the shadow map sees, by where balls and camera are.

#include <gtest/gtest.h>

#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "render/frame_data.h"

namespace drape {
namespace {

class ShadowBox : public testing::Test {
protected:
    ShadowBox() : simulation_("drop", load_scene("drop")), ball_(simulation_.balls()[0]) {}

    /// Of the map, as the scene's camera sees it from so many times its distance [m].
    [[nodiscard]] float texel(double distance = 1) {
        ViewSettings shown = simulation_.settings().view;
        shown.eye = shown.target + distance * (shown.eye - shown.target);
        FrameView view = simulation_.view();
        view.balls = view.previous_balls = {&ball_, 1};
        return make_frame_data(view, Camera(shown), {640, 480}, {640, 480}, 1024).shadow.x();
    }

    Simulation simulation_;
    Ball ball_;
};

TEST_F(ShadowBox, IsNotSpreadToABallThatIsFarAway) {
    const float fine = texel();
    ball_.centre += Vec3(30, 0, 40);
    EXPECT_LE(texel(), fine);
}

TEST_F(ShadowBox, HasABallThatComesNearToTheCloth) {
    const float fine = texel(0.01);
    ball_.centre.x() += Real(1.2);
    EXPECT_GT(texel(0.01), 1.2f * fine) << "also where the camera is too close to see it";
}

TEST_F(ShadowBox, HasAFarBallThatTheCameraSees) {
    ball_.centre += Vec3(30, 0, 40);
    EXPECT_GT(texel(100), 10 * texel());
}

}  // namespace
}  // namespace drape
