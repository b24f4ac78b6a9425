// What a renderer keeps from frame to frame never shows: its picture is that of a new renderer.

#include <gtest/gtest.h>

#include <vector>

#include "drawn_scene.h"

namespace drape::test {
namespace {

/// What the picture depends on.
struct Look {
    const char* change;
    Camera camera;
    std::vector<Ball> balls;
    Settings settings;
    int width = 320;
};

struct KeptStudio : DrawnScene, testing::Test {
    KeptStudio() : DrawnScene("drop", 0.2) {}

    Image draw(Renderer& renderer, const Look& shown) {
        view.settings = &shown.settings;
        view.balls = view.previous_balls = shown.balls;
        renderer.resize(shown.width, 180);
        renderer.draw(view, shown.camera, {});
        return renderer.read_back();
    }

    Look look_{"first", Camera(settings.view), {view.balls.begin(), view.balls.end()}, settings};
};

TEST_F(KeptStudio, FollowsCameraBallSizeAndGround) {
    std::vector<Look> looks{look_};
    const auto then = [&](const char* change) -> Look& {
        looks.push_back(looks.back());
        looks.back().change = change;
        return looks.back();
    };
    then("camera").camera.apply(parse_command("orbit 0.2 0.1"), simulation.view());
    then("ball").balls[0].centre.x() += 0.2;
    then("radius").balls[0].radius *= 0.5;
    then("size").width = 200;
    then("ground").settings.ground.height = -0.3;
    then("no ball").balls.clear();

    std::vector<Image> kept;
    {
        const GlContext context = make_context();
        Renderer renderer;
        for (const Look& one : looks) kept.push_back(draw(renderer, one));
    }
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const GlContext context = make_context();
        Renderer renderer;
        EXPECT_TRUE(kept[i].rgb == draw(renderer, looks[i]).rgb) << looks[i].change;
        if (i > 0) {
            EXPECT_FALSE(kept[i].rgb == kept[i - 1].rgb) << looks[i].change << " does not show";
        }
    }
}

TEST_F(KeptStudio, IsDrawnAgainOnlyIfItChanges) {
    const GlContext context = make_context();
    Renderer renderer;
    const auto calls = [&] {
        draw(renderer, look_);
        return renderer.report().gl_calls;
    };
    const double first = calls();
    const double same = calls();
    EXPECT_LT(same, first);
    look_.balls[0].centre.x() += 0.2;
    EXPECT_EQ(calls(), same);
    look_.camera.apply(parse_command("orbit 0.2 0.1"), simulation.view());
    EXPECT_GT(calls(), same);
}

}  // namespace
}  // namespace drape::test
