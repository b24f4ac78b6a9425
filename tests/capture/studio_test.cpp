// What a renderer keeps from frame to frame never shows: its picture is that of a new renderer.

#include <gtest/gtest.h>

#include <vector>

#include "capture/offscreen_context.h"
#include "drape/render/renderer.h"
#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"

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

class KeptStudio : public testing::Test {
protected:
    KeptStudio() {
        while (simulation_.report().time < 0.2) simulation_.step();
        const FrameView view = simulation_.view();
        look_.balls.assign(view.balls.begin(), view.balls.end());
    }

    Image draw(Renderer& renderer, const Look& look) {
        FrameView view = simulation_.view();
        view.settings = &look.settings;
        view.balls = view.previous_balls = look.balls;
        renderer.resize(look.width, 180);
        renderer.draw(view, look.camera, {});
        return renderer.read_back();
    }

    Simulation simulation_{"drop", [] {
                               Settings settings = load_scene("drop");
                               settings.view.panel = PanelSize::Off;
                               return settings;
                           }()};
    Look look_{"first", Camera(simulation_.settings().view), {}, simulation_.settings()};
};

TEST_F(KeptStudio, FollowsCameraBallSizeAndGround) {
    std::vector<Look> looks{look_};
    const auto then = [&](const char* change) -> Look& {
        looks.push_back(looks.back());
        looks.back().change = change;
        return looks.back();
    };
    then("camera").camera.apply(parse_command("orbit 0.2 0.1"), simulation_.view());
    then("ball").balls[0].centre.x() += 0.2;
    then("radius").balls[0].radius *= 0.5;
    then("size").width = 200;
    then("ground").settings.ground.height = -0.3;
    then("no ball").balls.clear();

    std::vector<Image> kept;
    {
        const OffscreenContext context;
        Renderer renderer;
        for (const Look& look : looks) kept.push_back(draw(renderer, look));
    }
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const OffscreenContext context;
        Renderer renderer;
        EXPECT_TRUE(kept[i].rgb == draw(renderer, looks[i]).rgb) << looks[i].change;
        if (i > 0) {
            EXPECT_FALSE(kept[i].rgb == kept[i - 1].rgb) << looks[i].change << " does not show";
        }
    }
}

TEST_F(KeptStudio, IsDrawnAgainOnlyIfItChanges) {
    const OffscreenContext context;
    Renderer renderer;
    const auto calls = [&] {
        draw(renderer, look_);
        return renderer.report().gl_calls;
    };
    const double first = calls();
    const double same = calls();
    EXPECT_LT(same, first);
    EXPECT_EQ(calls(), same);
    look_.balls[0].centre.x() += 0.2;
    EXPECT_GT(calls(), same);
}

}  // namespace
}  // namespace drape::test
