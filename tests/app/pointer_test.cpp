#include "../../src/app/pointer.h"

#include <gtest/gtest.h>

#include "sim/small_scene.h"

namespace drape {
namespace {

constexpr int page_width = 640, page_height = 480;

/// A scene under the mouse, and the pixel that its first ball's centre is seen at.
struct Pointed {
    explicit Pointed(const std::string& scene, const std::vector<std::string>& changes = {})
        : simulation(shipped_simulation(scene, changes)), camera(simulation.settings().view) {
        const Eigen::Matrix4f projection = camera.projection_matrix(float(page_width) / float(page_height));
        const Eigen::Vector4f seen =
            projection * camera.view_matrix() * simulation.balls()[0].centre.cast<float>().homogeneous();
        x = static_cast<int>((1 + seen.x() / seen.w()) / 2 * page_width);
        y = static_cast<int>((1 - seen.y() / seen.w()) / 2 * page_height);
    }

    /// Carries out what the pointer makes of it. @return the names of the commands
    std::string press() { return carry_out(pointer.press(Pointer::Button::Left, {}, x, y, sight())); }
    std::string drag(int right, int down) {
        pointer.move(x += right, y += down);
        return carry_out(pointer.flush(sight()));
    }
    std::string release() { return carry_out(pointer.release(Pointer::Button::Left, sight())); }

    Simulation simulation;
    Camera camera;
    int x = 0, y = 0;
    Pointer pointer;

private:
    [[nodiscard]] Sight sight() {
        view_ = simulation.view();
        return {view_, camera, page_width, page_height};
    }

    std::string carry_out(const std::vector<Command>& commands) {
        std::string names;
        for (const Command& command : commands) {
            simulation.apply(command);
            const std::string text = command_text(command);
            names += (names.empty() ? "" : " ") + text.substr(0, text.find(' '));
        }
        return names;
    }

    FrameView view_;
};

TEST(Pointer, LeadsABallWithTheGrabbedPointUnderIt) {
    for (const char* motion : {"free", "keys"}) {
        Pointed at("trampoline", {std::string("ball.motion=") + motion});
        at.x += 8, at.y -= 5;  // not at its middle
        EXPECT_EQ(at.press(), "hold");
        const Ball before = at.simulation.balls()[0];
        const Vec3 grabbed =
            pick_particle(at.simulation.view(), at.camera.ray(at.x, at.y, page_width, page_height)).point;
        EXPECT_EQ(at.drag(-90, -30), "drag");
        run_until(at.simulation, 1);
        const Vec3 moved = at.simulation.balls()[0].centre - before.centre;
        const Vec3 pointed = at.camera.on_facing_plane(at.camera.ray(at.x, at.y, page_width, page_height), grabbed);
        EXPECT_GT(moved.norm(), 0.2) << motion;
        EXPECT_LT((grabbed + moved - pointed).norm(), 2e-3) << motion;
        EXPECT_EQ(at.release(), "release");
    }
}

TEST(Pointer, TurnsTheViewAtABallThatIsStillOrOnAPath) {
    for (const char* scene : {"drop", "curtain"}) {
        Pointed at(scene, {"cloth.centre=0,9,0", "ground.solid=false"});
        EXPECT_EQ(at.press(), "") << scene;
        EXPECT_TRUE(at.pointer.orbits_from_ball()) << "which the user is told of";
        EXPECT_EQ(at.drag(20, 0), "orbit") << scene;
        at.release();
        at.y = page_height - 1;
        at.press();
        EXPECT_FALSE(at.pointer.orbits_from_ball()) << "beside it";
    }
}

TEST(Pointer, TakesTheClothBeforeABall) {
    Pointed at("original");
    const Pick pick = pick_particle(at.simulation.view(), at.camera.ray(at.x, at.y - 40, page_width, page_height));
    EXPECT_GE(pick.particle, 0);
    FrameView without_cloth = at.simulation.view();
    without_cloth.cloths = {};
    EXPECT_GE(pick_particle(without_cloth, at.camera.ray(at.x, at.y - 40, page_width, page_height)).ball, 0);
    at.y -= 40;
    EXPECT_EQ(at.press(), "grab");
}

}  // namespace
}  // namespace drape
