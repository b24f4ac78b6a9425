// Videos of the window.

#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "../../src/app/window_video.h"
#include "app/window_fixture.h"
#include "drape/base/numbers.h"
#include "support/scratch_folder.h"

namespace drape {
namespace {

namespace fs = std::filesystem;
using test::eventually;
using test::Process;
using test::read_file;
using test::WindowTest;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

/// Videos in a folder of the test's own, made by an ffmpeg of its own.
class WindowVideoTest : public testing::Test {
protected:
    WindowVideoTest() : before_(fs::current_path()), path_(std::getenv("PATH")) {
        fs::current_path(folder_.path());
        fs::create_directory("bin");
        setenv("PATH", (fs::absolute("bin").string() + ":/bin:/usr/bin").c_str(), 1);
    }
    ~WindowVideoTest() override {
        setenv("PATH", path_.c_str(), 1);
        fs::current_path(before_);
    }

    static void put_ffmpeg(const std::string& script) {
        std::ofstream("bin/ffmpeg") << "#!/bin/sh\nfor last; do :; done\n" << script << "\n";
        fs::permissions("bin/ffmpeg", fs::perms::owner_all);
    }

    static Image picture(PictureSize size = {8, 4}) {
        const auto bytes = static_cast<std::size_t>(3 * size.width * size.height);
        return {size.width, size.height, std::vector<std::uint8_t>(bytes, 'x')};
    }

    // Takes a picture as soon as it is due
    static void take(WindowVideo& video) {
        ASSERT_TRUE(eventually([&] { return video.due(); }));
        video.take(picture());
    }

    ScratchFolder folder_;
    fs::path before_;
    std::string path_;
    StopSignals signals_;
    WindowVideo video_{signals_};
};

TEST_F(WindowVideoTest, HasTheFramesThatItSays) {
    put_ffmpeg("cat > \"$last\"");
    EXPECT_THAT(video_.toggle({8, 4}), HasSubstr("Recording video to drape-0001.mp4"));
    for (int i = 0; i < 5; ++i) take(video_);
    video_.resize({8, 4});
    EXPECT_TRUE(video_.recording()) << "the window has the same size";
    EXPECT_THAT(video_.toggle({8, 4}), HasSubstr("drape-0001.mp4 is being finished"));
    EXPECT_FALSE(video_.due());
    const std::string told = video_.close();
    ASSERT_THAT(told, MatchesRegex("Video written: drape-0001\\.mp4, [0-9]+ frames"));
    const std::string count = told.substr(31, told.rfind(' ') - 31);
    EXPECT_GE(parse_integer(count).value_or(0), 5);
    EXPECT_EQ(read_file("drape-0001.mp4").size(), 96 * static_cast<std::size_t>(parse_integer(count).value_or(0)));
    EXPECT_EQ(video_.close(), "");
}

TEST_F(WindowVideoTest, NeverTakesThePlaceOfAFile) {
    put_ffmpeg("cat > \"$last\"");
    std::ofstream("drape-0001.mp4") << "before";
    EXPECT_THAT(video_.toggle({8, 4}), HasSubstr("drape-0002.mp4"));
    take(video_);
    std::ofstream("drape-0002.mp4") << "made meanwhile";
    EXPECT_THAT(video_.close(), HasSubstr("Video written: drape-0002-1.mp4"));
    EXPECT_EQ(read_file("drape-0001.mp4"), "before");
    EXPECT_EQ(read_file("drape-0002.mp4"), "made meanwhile");
    EXPECT_EQ(read_file("drape-0002-1.mp4").size() % 96, 0u);
}

TEST_F(WindowVideoTest, SaysWhyThereIsNone) {
    put_ffmpeg("exit 3");
    video_.toggle({800, 600});
    // More than a pipe holds
    ASSERT_TRUE(eventually([&] {
        if (video_.due()) video_.take(picture({800, 600}));
        return !video_.recording();
    }));
    std::string told;
    ASSERT_TRUE(eventually([&] { return !(told = video_.news()).empty(); }));
    EXPECT_EQ(told, "No video: ffmpeg failed with status 3");

    setenv("PATH", "/nowhere", 1);
    EXPECT_THAT(video_.toggle({8, 4}), HasSubstr("No video: ffmpeg (Debian package ffmpeg) could not be started"));
    EXPECT_FALSE(video_.recording());
    EXPECT_EQ(std::distance(fs::directory_iterator("."), fs::directory_iterator()), 1) << "bin, and nothing else";
}

TEST_F(WindowVideoTest, DoesNotWaitForEverForOneThatIsStopped) {
    put_ffmpeg("cat > \"$last\"; kill -STOP $$");
    WindowVideo video(signals_, 0.3);
    video.toggle({8, 4});
    take(video);
    EXPECT_EQ(video.close(), "No video: ffmpeg stood still and was ended");
    EXPECT_EQ(std::distance(fs::directory_iterator("."), fs::directory_iterator()), 1) << "bin, and nothing else";
}

// What ffprobe finds in a video: "640,480,12", width, height and frames.
std::string contents(const std::string& video) {
    const ScratchFolder place;
    Process probe({"/usr/bin/env", "ffprobe", "-v", "error", "-count_frames", "-show_entries",
                   "stream=width,height,nb_read_frames", "-of", "csv=p=0", video},
                  {}, place.path());
    EXPECT_EQ(probe.wait(60), 0) << probe.standard_error();
    std::string text = probe.standard_output();
    std::erase(text, '\n');
    return text;
}

bool is_red(const std::uint8_t* pixel) { return pixel[0] > 200 && pixel[1] < 60 && pixel[2] < 60; }

// Of fast pictures, too.
TEST_F(WindowTest, ShiftF12StartsAVideoAndEndsItAndAnotherSizeDoes) {
    start({"drop", "--set", "view.quality=fast"});
    for (const std::string name : {"drape-0001.mp4", "drape-0002.mp4"}) {
        const std::size_t before = commands().size();
        desktop_.key("shift+F12");
        ASSERT_TRUE(recorded("video", before));
        EXPECT_TRUE(eventually([&] { return is_red(desktop_.picture_of(window_).pixel(619, 21)); })) << "the mark";
        const double used = drape_->processor_time();
        ASSERT_TRUE(eventually([&] { return drape_->processor_time() > used + 0.15; }));
        EXPECT_FALSE(fs::exists(file(name))) << "before it is whole";
        if (name == "drape-0001.mp4") {
            desktop_.key("shift+F12");
        } else {
            desktop_.act({"windowsize", "--sync", window_, "500", "400"});
        }
        ASSERT_TRUE(eventually([&] { return fs::exists(file(name)); }));
        EXPECT_THAT(contents(file(name)), MatchesRegex("640,480,[0-9]+"));
    }
    quit();
}

TEST_F(WindowTest, TheEndOfTheProgramFinishesAVideo) {
    for (const bool signalled : {false, true}) {
        start({"hang"});
        desktop_.key("shift+F12");
        ASSERT_TRUE(recorded("video"));
        const double used = drape_->processor_time();
        ASSERT_TRUE(eventually([&] { return drape_->processor_time() > used + 0.15; }));
        signalled ? drape_->send(SIGTERM) : desktop_.key("ctrl+q");
        EXPECT_EQ(drape_->wait(60), signalled ? 128 + SIGTERM : 0);
        const std::string name = signalled ? "drape-0002.mp4" : "drape-0001.mp4";
        EXPECT_THAT(drape_->standard_error(), HasSubstr("drape: Video written: " + name));
        EXPECT_THAT(contents(file(name)), HasSubstr("640,480,"));
    }
}

}  // namespace
}  // namespace drape
