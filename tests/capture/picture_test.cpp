#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "drape/base/resources.h"
#include "drawn_scene.h"
#include "picture_check.h"
#include "support/process.h"
#include "support/scratch_folder.h"

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

using Picture = testing::TestWithParam<Moment>;

TEST_P(Picture, ShowsTheState) {
    const DrawnScene scene(GetParam().scene, GetParam().time, {"view.palette=studio"});
    EXPECT_THAT(complaints(picture_of(scene.view, picture_width, picture_height), scene.view), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Scenes, Picture,
                         testing::Values(Moment{"original", 0.5}, Moment{"drop", 0.25}, Moment{"curtain", 1.6},
                                         Moment{"hang", 1.0}, Moment{"two_corners", 0.4}),
                         [](const auto& one) { return std::string(one.param.scene); });

/// Pictures in which something is off, of a scene with cloth and ball.
struct WrongPicture : DrawnScene, testing::Test {
    WrongPicture() : DrawnScene("drop", 0.25) {}

    /// What is wrong where the shaders are copies, with a text in one of them replaced.
    std::vector<std::string> complaints_with(const std::string& file, const std::string& text,
                                             const std::string& fault) {
        const ScratchFolder folder;
        std::filesystem::copy(find_resource("shaders/" + file).parent_path(), folder.path() / "shaders",
                              std::filesystem::copy_options::recursive);
        std::string code = read_file(folder.path() / "shaders" / file);
        EXPECT_NE(code.find(text), std::string::npos);
        std::ofstream(folder.path() / "shaders" / file) << code.replace(code.find(text), text.size(), fault);
        setenv("DRAPE_DATA", folder.path().c_str(), 1);
        const Image image = picture_of(view, picture_width, picture_height);
        unsetenv("DRAPE_DATA");
        return complaints(image, view);
    }
};

TEST_F(WrongPicture, IsRefusedIfBallOrClothIsTwoPercentOff) {
    const Vec3 aside = Camera(settings.view).right() * Real(0.02);
    std::vector<Ball> balls(view.balls.begin(), view.balls.end());
    for (Ball& ball : balls) ball.centre += 2 * ball.radius * aside;
    FrameView planted = view;
    planted.balls = planted.previous_balls = balls;
    EXPECT_THAT(complaints(picture_of(planted, picture_width, picture_height), view), Contains(StartsWith("ball")));
    ViewSettings from = settings.view;
    from.eye += aside;
    from.target += aside;
    EXPECT_THAT(complaints(picture_of(view, picture_width, picture_height, from), view), Contains(StartsWith("cloth")));
}

TEST_F(WrongPicture, IsRefusedIfLightShadowOrSidesAreOff) {
    const auto dark = complaints_with("light.glsl", "const vec3 key_colour = ", "const vec3 key_colour = 0.0 * ");
    EXPECT_THAT(dark, Contains(StartsWith("light")));
    EXPECT_THAT(dark, Contains(StartsWith("shadow")));
    EXPECT_THAT(complaints_with("depth.vert", "gl_Position = ", "gl_Position = 0.0 * "),
                Contains(StartsWith("shadow")));
    EXPECT_THAT(complaints_with("cloth.frag", "if (!gl_FrontFacing)", "if (gl_FrontFacing)"),
                Contains(StartsWith("front")));
}

}  // namespace
}  // namespace drape::test
