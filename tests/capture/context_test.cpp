// Who draws where there is no display.

#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "capture/offscreen_context.h"
#include "drape/base/input_error.h"
#include "drape/render/renderer.h"
#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "program.h"

namespace drape::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

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

TEST(ContextChoice, IsEglOnlyWhereOsmesaIsMissing) {
    const MakeContext osmesa = made_by("osmesa"), egl = made_by("egl");
    EXPECT_EQ(maker(ContextKind::Auto, osmesa, egl), "osmesa");
    EXPECT_EQ(maker(ContextKind::Auto, missing("none"), egl), "egl");
    EXPECT_EQ(maker(ContextKind::Auto, osmesa, missing("none")), "osmesa");
}

TEST(ContextChoice, IsWhatWasAskedForOrNothing) {
    const MakeContext osmesa = made_by("osmesa"), egl = made_by("egl");
    EXPECT_EQ(maker(ContextKind::Osmesa, osmesa, egl), "osmesa");
    EXPECT_EQ(maker(ContextKind::Egl, osmesa, egl), "egl");
    EXPECT_EQ(maker(ContextKind::Osmesa, missing("no OSMesa"), egl), "no OSMesa");
    EXPECT_EQ(maker(ContextKind::Egl, osmesa, missing("no EGL")), "no EGL");
}

TEST(ContextChoice, SaysOfBothWhyThereIsNone) {
    EXPECT_THAT(maker(ContextKind::Auto, missing("no OSMesa"), missing("no EGL")),
                AllOf(HasSubstr("without a display"), HasSubstr("no OSMesa; no EGL")));
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
    const OffscreenContext context(kind);
    Renderer renderer;
    renderer.resize(640, 360);
    renderer.draw(view, Camera(view.settings->view), {});
    return renderer.read_back();
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
    Settings settings = load_scene("drop");
    settings.view.bounds = settings.view.contacts = settings.view.particles = true;
    Simulation simulation("drop", settings);
    while (simulation.report().time < 0.25) simulation.step();
    const FrameView view = simulation.view();
    const Image reference = drawn_by(ContextKind::Osmesa, view);
    EXPECT_LT(difference(reference, drawn_by(ContextKind::Egl, view)), tolerance);

    simulation.step();
    FrameView later = simulation.view();
    std::vector<Ball> balls(later.balls.begin(), later.balls.end());
    for (Ball& ball : balls) ball.centre.x() += Real(0.01);
    later.balls = later.previous_balls = balls;
    EXPECT_GT(difference(reference, drawn_by(ContextKind::Egl, later)), tolerance) << "a ball 1 cm aside is not seen";
}

TEST(Context, OfAKindIsUsedByTheProgram) {
    const TestFolder folder;
    for (const std::string kind : {"osmesa", "egl", "auto"}) {
        if (kind == "osmesa" && !has_osmesa()) continue;
        const Words words{"drop", "--frames", "1", "--size", "64x36", "--out", folder / kind, "--context", kind};
        const Outcome outcome = run_program("drape-capture", words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(read_png(folder / (kind + "/frame_0001.png")).width, 64);
    }
}

TEST(Context, OfOsmesaIsNotNeededAndItsPackageIsNamedWhereItIsMissing) {
    const TestFolder folder;
    // Found before the system's, and no library
    std::ofstream(folder / "libOSMesa.so.8") << "none";
    const std::vector<std::string> hidden{"LD_LIBRARY_PATH=" + (folder / "")};
    Words words{"drop", "--frames", "1", "--size", "64x36", "--out", folder / "a", "--context", "osmesa"};
    const Outcome refused = run_program("drape-capture", words, hidden);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, HasSubstr("drape-capture: OSMesa cannot be opened (Debian package libosmesa6"));
    words.back() = "auto";
    const Outcome drawn = run_program("drape-capture", words, hidden);
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_EQ(read_png(folder / "a/frame_0001.png").width, 64);
}

TEST(Context, ThatNobodyKnowsIsBadInput) {
    const Outcome outcome = run_program("drape-capture", {"drop", "--frames", "1", "--hash", "--context", "glx"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--context glx: allowed 'auto', 'osmesa' or 'egl'"));
}

TEST(Context, ThatCannotBeMadeIsTold) {
    const TestFolder folder;
    const Words words{"drop", "--frames", "1", "--size", "64x36", "--out", folder / "a", "--context", "egl"};
    // Where EGL's library finds no driver
    const Outcome outcome = run_program("drape-capture", words, {"__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("drape-capture: EGL has no surfaceless platform"));
    EXPECT_TRUE(folder.names("a").empty());
}

TEST(Context, GetsEveryCallOfOpenGl) {
    // A function that the program takes from a library goes to that library's context, whichever draws
    const std::string command = NAME_LISTER " -D --undefined-only " DRAPE_PROGRAMS "/drape-capture";
    FILE* const pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::string names;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) names += static_cast<char>(c);
    ASSERT_EQ(pclose(pipe), 0);
    EXPECT_THAT(names, HasSubstr(" eglCreateContext"));
    EXPECT_THAT(names, ::testing::Not(::testing::ContainsRegex(" gl[A-Z]")));
}

}  // namespace
}  // namespace drape::test
