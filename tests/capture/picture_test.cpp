#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include "capture/offscreen_context.h"
#include "drape/base/resources.h"
#include "drape/render/renderer.h"
#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "picture_check.h"

namespace drape::test {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr int picture_width = 1280, picture_height = 720;

/// A scene at a time at which its picture tells most.
struct Moment {
    const char* scene;
    double time;
    friend void PrintTo(const Moment& moment, std::ostream* out) { *out << moment.scene; }
};

class Picture : public testing::TestWithParam<Moment> {
protected:
    Picture() : simulation_(GetParam().scene, load_scene(GetParam().scene)) {
        while (simulation_.report().time < GetParam().time) simulation_.step();
        view_ = simulation_.view();
        settings_ = *view_.settings;
        settings_.view.panel = PanelSize::Off;
        view_.settings = &settings_;
    }

    ~Picture() override {
        if (!shaders_.empty()) std::filesystem::remove_all(shaders_);
    }

    /// Copies the shaders, with a text in one of them replaced: a fault planted in what is drawn.
    void plant_in_shader(const std::string& file, const std::string& text, const std::string& fault) {
        shaders_ = std::filesystem::path(testing::TempDir()) / ("drape-shaders-" + std::to_string(::getpid()));
        std::filesystem::create_directories(shaders_);
        std::filesystem::copy(find_resource("shaders/" + file).parent_path(), shaders_ / "shaders",
                              std::filesystem::copy_options::recursive);
        std::stringstream source;
        source << std::ifstream(shaders_ / "shaders" / file).rdbuf();
        std::string code = source.str();
        ASSERT_NE(code.find(text), std::string::npos);
        code.replace(code.find(text), text.size(), fault);
        std::ofstream(shaders_ / "shaders" / file) << code;
        setenv("DRAPE_DATA", shaders_.c_str(), 1);
    }

    Image draw(const FrameView& view, const ViewSettings& from) {
        OffscreenContext context;
        Renderer renderer;
        renderer.resize(picture_width, picture_height);
        renderer.draw(view, Camera(from), {});
        unsetenv("DRAPE_DATA");
        return renderer.read_back();
    }
    Image draw(const FrameView& view) { return draw(view, settings_.view); }

    Simulation simulation_;
    Settings settings_;
    FrameView view_;
    std::filesystem::path shaders_;
};

TEST_P(Picture, ShowsTheState) { EXPECT_THAT(complaints(draw(view_), view_), IsEmpty()); }

TEST_P(Picture, IsRefusedIfTheBallIsTwoPercentOff) {
    if (view_.balls.empty()) GTEST_SKIP() << "no ball";
    std::vector<Ball> balls(view_.balls.begin(), view_.balls.end());
    const Vec3 aside = Camera(settings_.view).right();
    for (Ball& ball : balls) ball.centre += Real(0.02) * 2 * ball.radius * aside;
    FrameView planted = view_;
    planted.balls = planted.previous_balls = balls;
    EXPECT_THAT(complaints(draw(planted), view_), Contains(StartsWith("ball")));
}

TEST_P(Picture, IsRefusedIfTheClothIsTwoPercentOff) {
    ViewSettings aside = settings_.view;
    const Vec3 step = Camera(aside).right() * Real(0.02);
    aside.eye += step;
    aside.target += step;
    EXPECT_THAT(complaints(draw(view_, aside), view_), Contains(StartsWith("cloth")));
}

TEST_P(Picture, IsRefusedIfTheLightIsOff) {
    plant_in_shader("light.glsl", "const vec3 key_colour = ", "const vec3 key_colour = 0.0 * ");
    const std::vector<std::string> found = complaints(draw(view_), view_);
    EXPECT_THAT(found, Contains(StartsWith("light")));
    EXPECT_THAT(found, Contains(StartsWith("shadow")));
}

TEST_P(Picture, IsRefusedIfNothingCastsAShadow) {
    plant_in_shader("depth.vert", "gl_Position = ", "gl_Position = 0.0 * ");
    EXPECT_THAT(complaints(draw(view_), view_), Contains(StartsWith("shadow")));
}

TEST_P(Picture, IsRefusedIfFrontAndBackAreSwapped) {
    plant_in_shader("cloth.frag", "if (!gl_FrontFacing)", "if (gl_FrontFacing)");
    EXPECT_THAT(complaints(draw(view_), view_), Contains(StartsWith("front")));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Picture,
                         testing::Values(Moment{"original", 0.5}, Moment{"drop", 0.25}, Moment{"curtain", 1.6},
                                         Moment{"hang", 1.0}, Moment{"two_corners", 0.4}),
                         [](const auto& one) { return std::string(one.param.scene); });

}  // namespace
}  // namespace drape::test
