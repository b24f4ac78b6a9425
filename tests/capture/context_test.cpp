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

/// A context that draws nothing, and knows who made it.
struct NamedContext : GlContext {
    explicit NamedContext(std::string maker) : name(std::move(maker)) {}
    [[nodiscard]] Function function(const char*) const override { return nullptr; }
    std::string name;
};

MakeContext made_by(const std::string& name) {
    return [name] { return std::make_unique<NamedContext>(name); };
}

MakeContext missing(const std::string& why) {
    return [why]() -> std::unique_ptr<GlContext> { throw RunError(why); };
}

std::string maker(ContextKind kind, const MakeContext& osmesa, const MakeContext& egl) {
    try {
        return dynamic_cast<NamedContext&>(*make_context(kind, osmesa, egl)).name;
    } catch (const RunError& error) {
        return error.what();
    }
}

TEST(ContextChoice, IsWhatWasAskedForAndEglOnlyWhereOsmesaIsMissing) {
    const MakeContext osmesa = made_by("osmesa"), egl = made_by("egl");
    const MakeContext no_osmesa = missing("no OSMesa"), no_egl = missing("no EGL");
    EXPECT_EQ(maker(ContextKind::Auto, osmesa, egl), "osmesa");
    EXPECT_EQ(maker(ContextKind::Auto, no_osmesa, egl), "egl");
    EXPECT_EQ(maker(ContextKind::Auto, osmesa, no_egl), "osmesa");
    EXPECT_THAT(maker(ContextKind::Auto, no_osmesa, no_egl),
                AllOf(HasSubstr("without a display"), HasSubstr("no OSMesa; no EGL")));
    EXPECT_EQ(maker(ContextKind::Osmesa, osmesa, egl), "osmesa");
    EXPECT_EQ(maker(ContextKind::Egl, osmesa, egl), "egl");
    EXPECT_EQ(maker(ContextKind::Osmesa, no_osmesa, egl), "no OSMesa");
    EXPECT_EQ(maker(ContextKind::Egl, osmesa, no_egl), "no EGL");
}

/// Whether this system has OSMesa, which Mesa has left out since its version 25.1.
bool has_osmesa() {
    try {
        return make_osmesa_context() != nullptr;
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
    for (int y = 0; y < one.height; ++y) {
        for (int x = 0; x < one.width; ++x) {
            int most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(one.pixel(x, y)[c] - other.pixel(x, y)[c]));
            far += most > 8 ? 1 : 0;
        }
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
    const Words words{"drop", "--frames", "1", "--size", "64x36", "--out", folder / "a", "--context", "egl"};
    // Where EGL's library finds no driver
    const Outcome outcome = run_program("drape-capture", words, {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"}});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("drape-capture: EGL has no surfaceless platform"));
    EXPECT_TRUE(folder.names("a").empty());
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
