#include "drape/render/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <numbers>

#include "resting_cloth.h"

namespace drape {
namespace {

ViewSettings looking(const Vec3& eye, const Vec3& target) {
    ViewSettings view;
    view.eye = eye;
    view.target = target;
    return view;
}

/// Ground, and two balls 20 m apart on each axis.
FrameView wide_view(double ground) {
    static Settings settings;
    static const std::vector<Ball> balls{{Vec3::Constant(-10), 1, Vec3::Zero()}, {Vec3::Constant(10), 1, Vec3::Zero()}};
    settings.ground.height = static_cast<Real>(ground);
    FrameView view;
    view.balls = balls;
    view.settings = &settings;
    return view;
}

Eigen::Vector3f on_screen(const Camera& camera, const Eigen::Vector3f& point) {
    return (camera.projection_matrix(1) * camera.view_matrix() * point.homogeneous()).hnormalized();
}

TEST(Camera, HasRightAtTheRightAndUpAtTheTop) {
    const Camera camera(looking({0, 0, 3}, {0, 0, 0}));
    EXPECT_GT(on_screen(camera, {0.1f, 0, 0}).x(), 0.05f);
    EXPECT_GT(on_screen(camera, {0, 0.1f, 0}).y(), 0.05f);
    EXPECT_TRUE(camera.right().isApprox(Vec3(1, 0, 0)));
    EXPECT_TRUE(camera.ahead().isApprox(Vec3(0, 0, -1)));
}

TEST(Camera, SendsItsRayThroughThePixelThatAPointIsSeenIn) {
    const Camera camera(looking({1.6, 0.9, 2.2}, {0, 0.1, 0}));
    const int width = 1280, height = 720;
    const Vec3 point(0.3, -0.2, 0.4);
    const Eigen::Vector2i pixel = test::pixel_of(point, camera, width, height);
    const Ray ray = camera.ray(pixel.x(), pixel.y(), width, height);
    EXPECT_NEAR(ray.direction.norm(), 1, 1e-6);
    EXPECT_LT(ray.direction.cross(point - ray.origin).norm(), 2e-3);
    EXPECT_GT(ray.direction.dot(point - ray.origin), 0);
    const Vec3 through(0.2, 0.1, -0.3), facing = camera.on_facing_plane(ray, through);
    EXPECT_LT(ray.direction.cross(facing - ray.origin).norm(), 1e-5);
    EXPECT_NEAR((facing - through).dot(Vec3(1.6, 0.8, 2.2).normalized()), 0, 1e-5);
}

TEST(Camera, OrbitKeepsTheDistanceAndPanAndZoomMoveByPartsOfIt) {
    Camera turning(looking({0, 1, 3}, {0, 0, 0}));
    turning.apply(command::Orbit{0.7, 0}, wide_view(-1000));
    EXPECT_NEAR(turning.eye().norm(), std::sqrt(10.0f), 1e-4);
    turning.apply(command::Orbit{0, 100}, wide_view(-1000));
    EXPECT_LT(turning.eye().y(), 0.9999f * std::sqrt(10.0f)) << "before the pole";
    EXPECT_GT(turning.eye().y(), 0.99f * std::sqrt(10.0f));
    EXPECT_TRUE(turning.view_matrix().allFinite());
    Camera camera(looking({0, 0, 2}, {0, 0, 0}));
    camera.apply(command::Pan{0.5, 0.25}, wide_view(-1000));
    EXPECT_TRUE(camera.eye().isApprox(Eigen::Vector3f(1, 0.5f, 2), 1e-5f));
    camera.apply(command::Zoom{0.5}, wide_view(-1000));
    EXPECT_NEAR(camera.eye().z(), 1, 1e-5);
    for (int i = 0; i < 100; ++i) camera.apply(command::Zoom{0.1}, wide_view(-1000));
    EXPECT_GT(camera.eye().z(), 0.05f);
    for (int i = 0; i < 100; ++i) camera.apply(command::Zoom{10}, wide_view(-1000));
    EXPECT_LT(camera.eye().z(), 100);
}

TEST(Camera, StaysAboveSolidGround) {
    const FrameView view = wide_view(-0.5);
    for (const char* command : {"orbit 0.3 -3", "pan 0 -5", "zoom 20"}) {
        Camera camera(looking({0, 0.2, 3}, {0, 0, 0}));
        camera.apply(parse_command("orbit 0 -0.1"), view);
        camera.apply(parse_command(command), view);
        EXPECT_GT(camera.eye().y(), -0.5f) << command;
        EXPECT_LT(camera.eye().y(), 2) << command << ": near it";
    }
}

TEST(Camera, PansNoFartherThanTheSceneReaches) {
    Camera camera(looking({0, 0.2, 3}, {0, 0, 0}));
    for (int i = 0; i < 100; ++i) camera.apply(command::Pan{0.5, 0.5}, wide_view(-1));
    EXPECT_LT(camera.target().cwiseAbs().maxCoeff(), 20);
}

TEST(Camera, SurvivesNumbersThatAreNone) {
    Camera camera(looking({0, 0, 2}, {0, 0, 0}));
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
        camera.apply(command::Orbit{bad, bad}, wide_view(-1000));
        camera.apply(command::Pan{bad, bad}, wide_view(-1000));
        camera.apply(command::Zoom{bad}, wide_view(-1000));
    }
    EXPECT_TRUE(camera.eye().allFinite());
    EXPECT_TRUE(Camera(looking({1, 1, 1}, {1, 1, 1})).view_matrix().allFinite());
}

TEST(Camera, FrameBringsEverythingIntoThePicture) {
    Settings settings;
    const std::vector<Ball> balls{{Vec3(5, 1, 0), Real(0.4), Vec3::Zero()}, {Vec3(-2, 0, 1), Real(0.2), Vec3::Zero()}};
    FrameView view;
    view.balls = balls;
    view.settings = &settings;
    Camera camera(looking({0, 0, 2}, {0, 0, 0}));
    camera.apply(command::Frame{}, view);
    for (const Ball& ball : balls) {
        for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
            const Eigen::Vector3f place = on_screen(camera, (ball.centre + ball.radius * side).cast<float>());
            EXPECT_LT(place.head<2>().cwiseAbs().maxCoeff(), 1.0f);
        }
    }
}

TEST(Camera, GoesHomeToTheViewOfItsScene) {
    Settings settings;
    settings.view = looking({0, 1, 2}, {0, 0.5, 0});
    FrameView view;
    view.settings = &settings;
    Camera camera(settings.view);
    for (const char* command : {"orbit 0.3 0.2", "pan 0.1 0.2", "zoom 2"}) camera.apply(parse_command(command), view);
    EXPECT_FALSE(camera == Camera(settings.view));
    camera.apply(command::Home{}, view);
    EXPECT_TRUE(camera == Camera(settings.view));
}

TEST(Camera, SeesABallUntilAllOfItIsOutOfThePicture) {
    const Camera camera(looking({0, 0, 3}, {0, 0, 0}));
    const auto sees = [&](const Vec3& centre, float aspect) { return camera.sees({centre, Real(0.2)}, aspect); };
    const Real edge = Real(1.033);  // 3 m times the tangent of half of the field of view
    EXPECT_TRUE(sees({edge + Real(0.19), 0, 0}, 1));
    EXPECT_FALSE(sees({edge + Real(0.22), 0, 0}, 1));
    EXPECT_TRUE(sees({edge + Real(0.22), 0, 0}, 2)) << "a wider picture";
    EXPECT_FALSE(sees({0, -edge - Real(0.22), 0}, 2));
    EXPECT_FALSE(sees({0, 0, 6}, 1)) << "behind";
}

Camera turned(double yaw, double pitch, double factor) {
    Camera camera(looking({0, 1, 3}, {0, 0, 0}));
    camera.apply(command::Orbit{yaw, pitch}, wide_view(-1000));
    camera.apply(command::Zoom{factor}, wide_view(-1000));
    camera.apply(command::Pan{0.2, 0.1}, wide_view(-1000));
    return camera;
}

TEST(EasedCamera, MakesTheSameWayInLongAndShortFramesAndTurnsTheShortWay) {
    const Camera goal = turned(1, 0.3, 0.5);
    Camera once = turned(0, 0, 1), often = once;
    once.ease_towards(goal, 0.12);
    for (int frame = 0; frame < 12; ++frame) often.ease_towards(goal, 0.01);
    EXPECT_TRUE(once.view_matrix().isApprox(often.view_matrix(), 1e-4f));
    Camera camera = turned(3, 0, 1);
    camera.ease_towards(turned(-3, 0, 1), 0.05);
    for (const double end : {-3, 3}) {
        EXPECT_LT(std::acos(camera.ahead().dot(turned(end, 0, 1).ahead())), 2 * std::numbers::pi - 6) << end;
    }
}

/// With equal bits, so that an idle window stops drawing.
TEST(EasedCamera, ArrivesAndStaysThere) {
    const Camera goal = turned(-2, 0.4, 2);
    Camera camera = turned(0, 0, 1);
    int frames = 0;
    while (camera.ease_towards(goal, 1.0 / 60)) ASSERT_LT(++frames, 120);
    EXPECT_GT(frames, 30);
    EXPECT_EQ(camera, goal);
    EXPECT_EQ(camera.view_matrix(), goal.view_matrix());
    Camera late = turned(0, 0, 1);
    late.ease_towards(goal, 1e6);
    EXPECT_EQ(late, goal) << "after a long pause";
}

}  // namespace
}  // namespace drape
