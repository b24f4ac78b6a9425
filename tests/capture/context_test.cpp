// Who draws where there is no display.

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "drape/base/input_error.h"
#include "drawn_scene.h"
#include "program.h"
#include "support/read_png.h"

namespace drape::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Whether this system has OSMesa, which Mesa has left out since its version 25.1.
bool has_osmesa() {
    try {
        make_osmesa_context();
        return true;
    } catch (const RunError&) {
        return false;
    }
}

Image drawn_by(ContextKind kind, const FrameView& view) {
    return picture_of(view, 640, 360, view.settings->view, kind);
}

/// The share of pixels in which two pictures differ by more than drivers may: 8 of 255 in one of the colours.
double difference(const Image& one, const Image& other) {
    int far = 0;
    for (std::size_t pixel = 0; pixel < one.rgb.size(); pixel += 3) {
        int most = 0;
        for (std::size_t c = pixel; c < pixel + 3; ++c) most = std::max(most, std::abs(one.rgb[c] - other.rgb[c]));
        far += most > 8 ? 1 : 0;
    }
    return double(far) / (one.width * one.height);
}

TEST(Context, DrawsTheSamePictureEitherWay) {
    if (!has_osmesa()) GTEST_SKIP() << "without OSMesa there is one way";
    constexpr double tolerance = 1e-3;  // of the pixels
    DrawnScene scene("drop", 0.25, {"view.bounds=true", "view.contacts=true", "view.particles=true"});
    const Image reference = drawn_by(ContextKind::Osmesa, scene.view);
    EXPECT_LT(difference(reference, drawn_by(ContextKind::Egl, scene.view)), tolerance);

    std::vector<Ball> balls(scene.view.balls.begin(), scene.view.balls.end());
    for (Ball& ball : balls) ball.centre.x() += Real(0.01);
    scene.view.balls = scene.view.previous_balls = balls;
    EXPECT_GT(difference(reference, drawn_by(ContextKind::Egl, scene.view)), tolerance) << "a ball 1 cm aside is seen";
}

TEST(Context, OfOsmesaIsNotNeededAndItsPackageIsNamedWhereItIsMissing) {
    const TestFolder folder;
    // Found before the system's, and no library
    std::ofstream(folder / "libOSMesa.so.8") << "none";
    const std::map<std::string, std::string> hidden{{"LD_LIBRARY_PATH", folder / ""}};
    Words words{"drop", "--frames", "1", "--size", "64x36", "--out", folder / "a", "--context", "osmesa"};
    const Outcome refused = run_program("drape-capture", words, hidden);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, HasSubstr("drape-capture: OSMesa cannot be opened (Debian package libosmesa6"));
    words.emplace_back("--again");
    for (const char* kind : {"auto", "egl"}) {
        words[words.size() - 2] = kind;
        const Outcome drawn = run_program("drape-capture", words, hidden);
        EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
        EXPECT_EQ(read_png(folder / "a/frame_0001.png").width, 64);
    }
    if (!has_osmesa()) return;
    words[words.size() - 2] = "osmesa";
    EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
}

TEST(Context, ThatCannotBeMadeIsTold) {
    const TestFolder folder;
    std::ofstream(folder / "libOSMesa.so.8") << "none";
    Words words{"drop", "--frames", "1", "--size", "64x36", "--out", folder / "a", "--context", "egl"};
    // Where EGL's library finds no driver
    const std::map<std::string, std::string> hidden{{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"},
                                                    {"LD_LIBRARY_PATH", folder / ""}};
    const Outcome outcome = run_program("drape-capture", words, hidden);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("drape-capture: EGL has no surfaceless platform"));
    EXPECT_TRUE(folder.names("a").empty());
    words.back() = "auto";
    EXPECT_THAT(run_program("drape-capture", words, hidden).err,
                AllOf(HasSubstr("without a display: OSMesa cannot be opened"), HasSubstr("; EGL has no surfaceless")));
}

TEST(Context, GetsEveryCallOfOpenGl) {
    // A function that the program takes from a library goes to that library's context, whichever draws
    const TestFolder folder;
    Process lister({NAME_LISTER, "-D", "--undefined-only", DRAPE_PROGRAMS "/drape-capture"}, {}, folder.path());
    ASSERT_EQ(lister.wait_to_end(), 0);
    const std::string names = lister.standard_output();
    EXPECT_THAT(names, HasSubstr(" eglCreateContext"));
    EXPECT_THAT(names, ::testing::Not(::testing::ContainsRegex(" gl[A-Z]")));
}

}  // namespace
}  // namespace drape::test
