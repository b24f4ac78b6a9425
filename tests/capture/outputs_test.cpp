// What drape-capture does to files that are there already, and how it ends when it is told to.

#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "drape/base/numbers.h"
#include "drape/base/unfinished_file.h"
#include "drape/render/image.h"
#include "program.h"
#include "support/read_png.h"

namespace drape::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

/// A run of a few small frames.
Words small(const Words& more) { return joined({"hang", "--size", "64x48", "--fps", "120"}, more); }

/// A run whose frame is more than a pipe holds.
Words large(const Words& more) { return joined({"hang", "--size", "480x270", "--fps", "120"}, more); }

void put(const std::string& file, const std::string& text) { std::ofstream(file) << text; }

TEST(CaptureOutputs, AreNoFileTwice) {
    const TestFolder folder;
    put(folder / "s", "before");
    fs::create_symlink("s", folder / "link");
    fs::create_directory(folder / "a");
    put(folder / "r.mp4", "drape-recording 1\nscene hang\n9 end\n");
    const auto refused = [&](const Words& words) {
        const Outcome outcome = run_program("drape-capture", small(joined({"--frames", "1"}, words)));
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_EQ(read_file(folder / "s"), "before");
        return outcome.err;
    };
    EXPECT_THAT(refused({"--video", folder / "v.mp4", "--stats", folder / "./v.mp4"}),
                AllOf(HasSubstr("--video "), HasSubstr(" and --stats ")));
    EXPECT_THAT(refused({"--state", folder / "s", "--stats", folder / "link"}), HasSubstr(" and --state "));
    EXPECT_THAT(refused({"--replay", folder / "r.mp4", "--state", folder / "a/../r.mp4"}), HasSubstr("--replay "));
    EXPECT_THAT(refused({"--replay", folder / "r.mp4", "--video", folder / "./r.mp4"}), HasSubstr("--replay "));
    EXPECT_THAT(refused({"--out", folder / "a", "--state", folder / "a/../a/frame_0001.png"}), HasSubstr("a frame of"));
    EXPECT_THAT(folder.names(""), ElementsAre("a", "link", "r.mp4", "s"));
}

TEST(CaptureOutputs, AreNoVideosThatAreNotOneFile) {
    const TestFolder folder;
    for (const char* name : {"x%d.png", "x.png", "v.m3u8", "v", "v.mp4.txt"}) {
        const Outcome outcome = run_program("drape-capture", small({"--frames", "1", "--video", folder / name}));
        EXPECT_EQ(outcome.exit_code, 2) << name;
        EXPECT_THAT(outcome.err, HasSubstr("allowed a name that ends in '.mp4', "));
    }
    EXPECT_THAT(folder.names(""), testing::IsEmpty());
    put_ffmpeg(folder, "cat > /dev/null\n");
    const Outcome outcome =
        run_program("drape-capture", small({"--frames", "1", "--video", folder / "%d.MP4"}), path_from(folder));
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("no video, ffmpeg has written nothing"));
    EXPECT_THAT(folder.names(""), ElementsAre("ffmpeg"));
}

TEST(CaptureOutputs, AreNotBegunWithTooLittleMemory) {
    const TestFolder folder;
    const std::string command =
        std::string("ulimit -v 500000; exec ") + DRAPE_PROGRAMS + "/drape-capture drop --frames 1 --state s.csv ";
    for (const char* more : {"--out a", "--out a --context egl", "--stats t.csv", "--video v.mp4"}) {
        Process run({"sh", "-c", command + more}, {}, folder / "");
        EXPECT_EQ(run.wait(60), 1) << more;
        EXPECT_THAT(run.standard_error(), AllOf(HasSubstr("out of memory: pictures"), HasSubstr("ulimit -v")));
    }
    EXPECT_THAT(folder.names(""), ElementsAre("stderr.txt", "stdout.txt")) << "nothing is begun";
    Process run({"sh", "-c", command + "--hash"}, {}, folder / "");
    EXPECT_EQ(run.wait(60), 0) << "no pictures, no need";
}

TEST(CaptureOutputs, KeepTheVideoOfBeforeIfThereIsNoNewOne) {
    const TestFolder folder, programs;
    put(folder / "v.mp4", "before");
    const auto film = [&](const std::map<std::string, std::string>& path, int code) {
        const Words words{"--frames", "2", "--out", folder / "a", "--again", "--video", folder / "v.mp4"};
        const Outcome run = run_program("drape-capture", small(words), path);
        EXPECT_EQ(folder.names("a").size(), 2u) << "the pictures stay";
        EXPECT_EQ(run.exit_code, code);
        return run.err;
    };
    EXPECT_THAT(film({{"PATH", "/nowhere"}}, 1), HasSubstr("ffmpeg (Debian package ffmpeg) could not be started"));
    EXPECT_EQ(read_file(folder / "v.mp4"), "before");
    put_ffmpeg(programs, "for last; do :; done; echo half > \"$last\"; cat > /dev/null; exit 1\n");
    EXPECT_THAT(film(path_from(programs), 1), HasSubstr("ffmpeg failed with status 1"));
    EXPECT_EQ(read_file(folder / "v.mp4"), "before");
    put_ffmpeg(programs, "for last; do :; done; echo whole > \"$last\"; cat > /dev/null\n");
    film(path_from(programs), 0);
    EXPECT_EQ(read_file(folder / "v.mp4"), "whole\n");
    EXPECT_THAT(folder.names(""), ElementsAre("a", "v.mp4"));
}

TEST(CaptureFrames, OfAnEarlierRunAreNotMixedWithNewOnes) {
    const TestFolder folder;
    const auto capture = [&](const Words& words) {
        return run_program("drape-capture", small(joined({"--out", folder / "a"}, words)));
    };
    ASSERT_EQ(capture({"--frames", "4"}).exit_code, 0);
    put(folder / "a/frame_cover.png", "not ours");
    const std::string first = read_file(folder / "a/frame_0001.png");
    const Outcome refused = capture({"--frames", "2", "--set", "view.wireframe=true"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("frame_0001.png of an earlier run"), HasSubstr("--again")));
    const Outcome failed = capture({"--frames", "60", "--again", "--set", "contact.self=false", "solver.dt=0.02",
                                    "solver.integrator=explicit_euler"});
    EXPECT_EQ(failed.exit_code, 1);
    EXPECT_TRUE(fs::exists(folder / "a/frame_0004.png")) << "the new run did not end";
    for (const char* left : {"unstable.csv", "unstable.toml"})
        EXPECT_TRUE(fs::remove(folder / ("a/" + std::string(left)))) << left;

    EXPECT_EQ(capture({"--frames", "2", "--set", "view.wireframe=true", "--again"}).exit_code, 0);
    EXPECT_THAT(folder.names("a"), ElementsAre("frame_0001.png", "frame_0002.png", "frame_cover.png"));
    EXPECT_NE(read_file(folder / "a/frame_0001.png"), first);
    EXPECT_EQ(capture({"--frames", "4", "--every", "4", "--again"}).exit_code, 0);
    EXPECT_THAT(folder.names("a"), ElementsAre("frame_0004.png", "frame_cover.png"));
}

TEST(CaptureFrames, AreWrittenByOneRunAtATime) {
    const TestFolder folder;
    fs::create_directory(folder / "a");
    const Words words = small({"--frames", "1", "--again", "--out", folder / "a"});
    {
        const UnfinishedFile other(folder / "a/frames.lock");
        const Outcome outcome = run_program("drape-capture", words);
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_THAT(outcome.err, HasSubstr("another run is writing "));
        EXPECT_THAT(folder.names("a"), ElementsAre(".frames.drape.lock"));
    }
    EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
    EXPECT_THAT(folder.names("a"), ElementsAre("frame_0001.png"));
}

/// The one line that tells of a frame that could not be written, after those that count the pictures.
::testing::Matcher<const std::string&> tells_of_frames(const std::string& frame, const std::string& reason,
                                                       const std::string& last) {
    return ::testing::MatchesRegex("([0-9]+ of [0-9]+ pictures, about [^\n]* left\n)*drape-capture: " + frame +
                                   "\\.png: cannot be written: " + reason + "; the last good frame is " + last +
                                   "\\.png\n");
}

TEST(CaptureFrames, EndTheRunWhereTheirFolderGoesAway) {
    const TestFolder folder;
    Running run(folder, small({"--frames", "100000", "--out", "a"}));
    ASSERT_TRUE(eventually([&] { return fs::exists(folder / "a/frame_000002.png"); }));
    fs::rename(folder / "a", folder / "b");
    EXPECT_EQ(run.wait(60), 1);
    EXPECT_THAT(run.standard_error(), tells_of_frames("a/frame_[0-9]*", ".*", "a/frame_[0-9]*"));
    // The picture that was being written goes with its folder: under a hidden name, and never under that of a frame
    for (const std::string& name : folder.names("b")) {
        if (name.starts_with("frame_")) {
            EXPECT_EQ(read_png(folder / ("b/" + name)).width, 64) << name;
        }
    }
}

TEST(CaptureSignals, LetAFrameBeFinished) {
    const TestFolder folder;
    Running run(folder, small({"--frames", "100000", "--out", folder / "a", "--stats", folder / "s.csv"}));
    ASSERT_TRUE(eventually([&] { return fs::exists(folder / "a/frame_000002.png"); }));
    run.send(SIGINT);
    EXPECT_EQ(run.wait(60), 128 + SIGINT);
    const Words names = folder.names("a");
    EXPECT_EQ(read_png(folder / "a/" + names.back()).width, 64);
    const std::string stats = read_file(folder / "s.csv");
    EXPECT_EQ(std::ranges::count(stats, '\n'), std::ssize(names) + 2) << "a row a frame, below names and units";
}

TEST(CaptureSignals, AreSeenBetweenTwoStepsOfALongFrame) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const TestFolder folder;
        Running run(folder, {"hang", "--frames", "1", "--fps", "0.001", "--set", "solver.sleep_speed=0", "--state",
                             folder / "state"});
        ASSERT_TRUE(eventually([&] { return fs::exists(folder / ".state.drape"); }));
        run.send(signal);
        EXPECT_EQ(run.wait(20), 128 + signal);
        EXPECT_THAT(read_file(folder / "state"), HasSubstr("particle")) << "the state that it has come to";
    }
}

/// An ffmpeg that stops, with its number in a file; killed at the end of the test.
class StoppedFfmpeg {
public:
    explicit StoppedFfmpeg(const TestFolder& folder) : file_(folder / "number") {
        put_ffmpeg(folder, "echo $$ > " + file_ + ".part; mv " + file_ + ".part " + file_ + "; kill -STOP $$\n");
    }
    ~StoppedFfmpeg() {
        if (const auto id = number()) kill(*id, SIGKILL);
    }
    StoppedFfmpeg(const StoppedFfmpeg&) = delete;
    StoppedFfmpeg& operator=(const StoppedFfmpeg&) = delete;

    [[nodiscard]] std::optional<pid_t> number() const {
        const std::string text = read_file(file_);
        const auto id = text.empty() ? std::nullopt : parse_integer(text.substr(0, text.size() - 1));
        return id ? std::optional(static_cast<pid_t>(*id)) : std::nullopt;
    }

private:
    std::string file_;
};

TEST(CaptureSignals, EndARunWhoseFfmpegStandsStill) {
    const TestFolder folder;
    const StoppedFfmpeg ffmpeg(folder);
    put(folder / "v.mp4", "before");
    Running run(folder, large({"--frames", "9", "--out", folder / "a", "--video", folder / "v.mp4"}));
    ASSERT_TRUE(eventually([&] { return ffmpeg.number() && fs::exists(folder / "a/frame_0001.png"); }));
    run.send(SIGINT);
    EXPECT_EQ(run.wait(60), 128 + SIGINT);
    EXPECT_THAT(run.standard_error(), HasSubstr("no video, ffmpeg stood still"));
    EXPECT_EQ(read_file(folder / "v.mp4"), "before");
    EXPECT_EQ(kill(*ffmpeg.number(), 0), -1) << "it is left behind";
    EXPECT_THAT(folder.names(""), Not(Contains(HasSubstr(".drape"))));
}

TEST(CaptureSignals, EndARunAtOnceTheSecondTime) {
    const TestFolder folder;
    const StoppedFfmpeg ffmpeg(folder);
    const Words words = large({"--frames", "9", "--out", folder / "a", "--again", "--video", folder / "v.mp4"});
    {
        Running run(folder, words);
        ASSERT_TRUE(eventually([&] { return ffmpeg.number() && fs::exists(folder / "a/frame_0001.png"); }));
        run.send(SIGINT);
        run.send(SIGTERM);
        EXPECT_THAT(run.wait(60), ::testing::AnyOf(256 + SIGTERM, 256 + SIGINT));
    }
    EXPECT_THAT(folder.names(""), Contains(HasSubstr(".drape")));
    put_ffmpeg(folder, "for last; do :; done; cat > \"$last\"\n");
    EXPECT_EQ(run_program("drape-capture", words, path_from(folder)).exit_code, 0);
    EXPECT_THAT(folder.names(""), Not(Contains(HasSubstr(".drape")))) << "what it has left is still there";
}

}  // namespace
}  // namespace drape::test
