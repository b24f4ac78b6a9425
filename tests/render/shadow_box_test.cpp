// How finely the shadow map sees, by where balls and camera are.

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>

#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "render/frame_data.h"

namespace drape {
namespace {

class ShadowBox : public testing::Test {
protected:
    ShadowBox() : simulation_("drop", load_scene("drop")), ball_(simulation_.balls()[0]) {}

    /// As the scene's camera sees the ball from so many times its distance.
    [[nodiscard]] FrameData data(double distance = 1) {
        ViewSettings shown = simulation_.settings().view;
        shown.eye = shown.target + distance * (shown.eye - shown.target);
        FrameView view = simulation_.view();
        view.balls = view.previous_balls = {&ball_, 1};
        return make_frame_data(view, Camera(shown), {640, 480}, {640, 480}, 1024);
    }

    /// Of the map [m].
    [[nodiscard]] float texel(double distance = 1) { return data(distance).shadow.x(); }

    /// The farthest that the ball is from the middle of the map; 1: at its edge.
    [[nodiscard]] float off_the_middle() {
        const Eigen::Matrix4f to_map = data().shadow_matrix;
        float most = 0;
        for (const Vec3& side : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
            for (const Real sign : {-1, 1}) {
                const Vec3 p = ball_.centre + sign * ball_.radius * side;
                const Eigen::Vector4f at = to_map * p.cast<float>().homogeneous();
                most = std::max(most, at.head<2>().cwiseAbs().maxCoeff());
            }
        }
        return most;
    }

    Simulation simulation_;
    Ball ball_;
};

TEST_F(ShadowBox, IsSpreadToABallNearTheClothOrInThePictureAndToNoOther) {
    const float fine = texel(), close = texel(0.01);
    const Vec3 start = ball_.centre;
    ball_.centre.x() += Real(1.2);
    EXPECT_GT(texel(0.01), 1.2f * close) << "also where the camera is too close to see it";
    ball_.centre = start + Vec3(30, 0, 40);
    EXPECT_LE(texel(), fine);
    EXPECT_GT(texel(100), 10 * texel()) << "seen from far away";
}

TEST_F(ShadowBox, HasAllOfABallThatIsHighAboveTheClothOrAtTheEdgeOfWhatIsSeen) {
    const Vec3 start = ball_.centre, up = data().to_light.head<3>().cast<Real>();
    const Vec3 aside = up.cross(Vec3(0, 0, 1)).normalized();
    for (const Real above : {0, 2, 30}) {
        for (const Real side : {Real(0), Real(1), Real(1.5)}) {
            ball_.centre = start + above * up + side * aside;
            EXPECT_LT(off_the_middle(), 1) << above << " m up, " << side << " m aside";
        }
    }
}

}  // namespace
}  // namespace drape
