#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "drape/base/commit.h"
#include "drape/render/image.h"
#include "drape/render/renderer.h"
#include "drape/sim/step_report.h"
#include "drape/sim/tour.h"
#include "program.h"

namespace drape::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

/// A run of a few small frames.
Words small(const std::string& scene, Words more) {
    Words words{scene, "--size", "160x90", "--fps", "120"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

Words columns(const std::string& line) {
    Words all;
    std::stringstream in(line);
    for (std::string word; std::getline(in, word, ',');) all.push_back(word);
    return all;
}

std::vector<Words> table(const std::string& file) {
    std::vector<Words> rows;
    std::stringstream in(text_of(file));
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with('#')) rows.push_back(columns(line));
    }
    return rows;
}

TEST(Capture, WritesNumberedFramesAndNothingElse) {
    const TestFolder folder;
    EXPECT_EQ(run_program("drape-capture", small("drop", {"--frames", "3", "--out", folder / "a/b"})).exit_code, 0);
    EXPECT_THAT(folder.names("a/b"), ElementsAre("frame_0001.png", "frame_0002.png", "frame_0003.png"));
    EXPECT_EQ(read_png(folder / "a/b/frame_0003.png").width, 160);
}

TEST(Capture, ClosesWithTheNumberOfItsPictures) {
    const TestFolder folder;
    const Words words = small("drop", {"--frames", "7", "--every", "3", "--out", folder / "a"});
    EXPECT_THAT(run_program("drape-capture", words).err, testing::EndsWith("2 pictures in " + (folder / "a") + "\n"));
}

TEST(Capture, DrawsEverySoManiethFrame) {
    const TestFolder folder;
    const Words words = small("drop", {"--frames", "7", "--every", "3", "--out", folder / "a"});
    EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
    EXPECT_THAT(folder.names("a"), ElementsAre("frame_0003.png", "frame_0006.png"));
}

TEST(Capture, ReachesTheSameStateAsTheLab) {
    const TestFolder folder;
    const Outcome lab = run_program("drape-lab", {"simulate", "curtain", "--time", "0.25", "--hash"});
    const Words hash{"curtain", "--frames", "15", "--fps", "60", "--hash"};
    EXPECT_EQ(run_program("drape-capture", hash).out, lab.out);
    Words drawn = hash;
    drawn.insert(drawn.end(), {"--size", "64x36", "--out", folder / "a", "--every", "5", "--overlay"});
    EXPECT_EQ(run_program("drape-capture", drawn).out, lab.out);
    EXPECT_EQ(lab.out.size(), 17u);
}

TEST(Capture, WritesARowOfEveryFieldForEachFrame) {
    const TestFolder folder;
    const std::string file = folder / "s.csv";
    EXPECT_EQ(run_program("drape-capture", small("drop", {"--frames", "4", "--every", "2", "--stats", file})).exit_code,
              0);
    const std::vector<Words> rows = table(file);
    ASSERT_EQ(rows.size(), 3u);
    Words wanted{"frame"};
    for (const ReportField& field : report_fields()) wanted.emplace_back(field.name);
    for (const FrameField& field : frame_fields()) wanted.emplace_back(field.name);
    for (const BallField& field : ball_fields()) wanted.emplace_back("ball0_" + std::string(field.name));
    EXPECT_EQ(rows[0], wanted);
    for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_EQ(rows[i].size(), wanted.size());
    EXPECT_EQ(rows[1][0], "2");
    EXPECT_EQ(rows[2][0], "4");
}

TEST(Capture, GivesTheUnitsOfItsFigures) {
    const TestFolder folder;
    const std::string file = folder / "s.csv";
    run_program("drape-capture", small("drop", {"--frames", "1", "--stats", file}));
    EXPECT_THAT(text_of(file), testing::StartsWith("# units: time [s], step_limit_ratio [1], "));
    for (const FrameField& field : frame_fields()) {
        if (field.unit.empty()) continue;
        EXPECT_THAT(text_of(file), HasSubstr(", " + std::string(field.name) + " [" + std::string(field.unit) + "]"));
    }
}

TEST(Capture, CountsItsFramesFromTheStartOfTheScene) {
    const TestFolder folder;
    const std::string start = folder / "start.csv", end = folder / "end.csv";
    const Words scene{"two_corners", "--set", "sleep_speed=0"};
    const auto with = [&](Words words) {
        words.insert(words.begin(), scene.begin(), scene.end());
        return words;
    };
    run_program("drape-capture", with({"--frames", "6", "--state", start}));
    const Outcome whole = run_program("drape-capture", with({"--frames", "9", "--hash"}));
    const Outcome rest =
        run_program("drape-capture", with({"start=" + start, "--frames", "3", "--hash", "--state", end}));
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(rest.out, whole.out);
    EXPECT_NEAR(std::stod(table(end).at(1).at(0)), 0.15, 1e-12);
}

TEST(Capture, SaysThatARecordingWasCutAndFailsWhereACommandIsRefused) {
    const TestFolder folder;
    const std::string cut = folder / "cut.txt", refused = folder / "refused.txt";
    std::ofstream(cut) << "drape-recording 1\nscene drop\n2 set dt=1e-4\n3 se";
    std::ofstream(refused) << "drape-recording 1\nscene drop\n2 grab 1 0\n3 end\n";
    const Outcome first = run_program("drape-capture", {"--replay", cut, "--frames", "1", "--hash"});
    EXPECT_EQ(first.exit_code, 0);
    EXPECT_THAT(first.err, HasSubstr(cut + ":4: cut off"));
    const Outcome second = run_program("drape-capture", {"--replay", refused, "--frames", "1", "--hash"});
    EXPECT_EQ(second.exit_code, 1);
    EXPECT_THAT(second.err, HasSubstr(refused + ":3: 'grab 1 0' is refused"));
}

TEST(Capture, RefusesAnOptionInThePlaceOfAValue) {
    const Outcome run = run_program("drape-capture", {"drop", "--frames", "1", "--out", "--hash"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr("--out needs a value, and '--hash' is an option"));
}

TEST(Capture, WritesTheLastState) {
    const TestFolder folder;
    const std::string ours = folder / "a.csv", labs = folder / "b.csv";
    run_program("drape-capture", {"two_corners", "--frames", "6", "--fps", "60", "--state", ours});
    run_program("drape-lab", {"simulate", "two_corners", "--time", "0.1", "--state", labs});
    EXPECT_EQ(text_of(ours), text_of(labs));
    EXPECT_GT(text_of(ours).size(), 1000u);
}

/// The greatest number in a column of the figures of frames, but for the first, which also sends what stays the same.
double most_of(const std::string& file, const std::string& name) {
    const std::vector<Words> rows = table(file);
    const auto column = std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin();
    double most = 0;
    for (std::size_t i = 2; i < rows.size(); ++i)
        most = std::max(most, std::stod(rows[i][static_cast<std::size_t>(column)]));
    return most;
}

TEST(Capture, DrawsFastWithFewerVerticesOfALargeCloth) {
    const TestFolder folder;
    const auto draw = [&](const std::string& quality) {
        const std::string folder_of_it = folder / quality, file = folder / (quality + ".csv");
        const Words words = small("hang", {"--frames", "2", "--out", folder_of_it, "--stats", file, "--set",
                                           "cloth.particles=160,160", "dt=1e-5", "view.quality=" + quality});
        EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
        return std::pair{read_png(folder_of_it + "/frame_0002.png").rgb, most_of(file, "vertices")};
    };
    const auto [full, full_vertices] = draw("full");
    const auto [fast, fast_vertices] = draw("fast");
    EXPECT_TRUE(full == draw("auto").first) << "a capture has time";
    EXPECT_TRUE(full != fast);
    EXPECT_LT(fast_vertices, 0.4 * full_vertices);
}

TEST(Capture, NeedsAtMostSixtyCallsForThePictureWithEverythingOn) {
    const TestFolder folder;
    const std::string file = folder / "s.csv";
    const Words words =
        small("drop", {"--frames", "60", "--every", "6", "--out", folder / "a", "--stats", file, "--set",
                       "view.bounds=true", "view.contacts=true", "view.particles=true", "view.wireframe=true"});
    EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
    ASSERT_EQ(table(file).size(), 11u);
    const double most = most_of(file, "gl_calls");
    EXPECT_LE(most, 60);
    EXPECT_GT(most, 40) << "less than all of it can need";
}

/// The most OpenGL calls of a frame but the first.
double most_calls(const Words& shown) {
    const TestFolder folder;
    const std::string file = folder / "s.csv";
    Words words{"drop",  "--size",     "640x360", "--frames", "40",    "--every",          "10",
                "--out", folder / "a", "--stats", file,       "--set", "view.bounds=true", "view.level=2"};
    words.insert(words.end(), shown.begin(), shown.end());
    EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
    EXPECT_EQ(table(file).size(), 5u);
    return most_of(file, "gl_calls");
}

TEST(Capture, NeedsFewCallsForThePanelsBesideThoseForThePicture) {
    const double picture = most_calls({});
    const double figures = most_calls({"view.panel=full", "view.plots=true", "--overlay"});
    const double settings = most_calls({"view.panel=full", "view.plots=true", "view.controls=true", "--overlay"});
    EXPECT_LE(picture, 60);
    EXPECT_GT(figures, picture) << "panels are drawn";
    EXPECT_LE(figures - picture, 6) << "figures, plots and the table of the hierarchy are one draw call";
    EXPECT_GT(settings, figures);
    EXPECT_LE(settings - figures, 12) << "the settings scroll in a window of their own";
}

TEST(Capture, RefusesBadNumbersWithTheirRange) {
    for (const auto& [words, said] : std::vector<std::pair<Words, std::string>>{
             {{"--frames", "0"}, "--frames 0: allowed 1 to"},
             {{"--frames", "two"}, "--frames two"},
             {{"--frames", "1", "--size", "0x5"}, "--size 0x5: allowed WxH, 1 to 8192 each"},
             {{"--frames", "1", "--size", "9000x5"}, "--size 9000x5"},
             {{"--frames", "1", "--size", "12"}, "--size 12"},
             {{"--frames", "1", "--fps", "nan"}, "--fps nan"},
             {{"--frames", "2", "--every", "3"}, "--every 3"},
             {{"--hash", "--frames", "1", "--set", "dt=-1"}, "dt"},
             {{"nowhere", "--hash", "--frames", "1"}, "nowhere"},
             {{}, "--frames"}}) {
        const Outcome outcome = run_program("drape-capture", words);
        EXPECT_EQ(outcome.exit_code, 2) << said;
        EXPECT_THAT(outcome.err, HasSubstr(said));
    }
}

TEST(Capture, SaysInItsPicturesHowTheyWereMade) {
    const TestFolder folder;
    run_program("drape-capture", small("drop", {"--frames", "1", "--out", folder / "a", "--set", "dt=1e-4"}));
    const std::string bytes = text_of(folder / "a/frame_0001.png");
    const auto chunk = [](const std::string& keyword, const std::string& text) {
        return "iTXt" + keyword + std::string(5, '\0') + text;
    };
    EXPECT_THAT(bytes, HasSubstr(chunk("Commit", commit())));
    EXPECT_THAT(bytes, HasSubstr(chunk("Scene", "drop")));
    EXPECT_THAT(bytes, HasSubstr(chunk("Time", "0.0083 s")));
    EXPECT_THAT(bytes, HasSubstr("dt = 1e-04"));
}

TEST(Capture, DrawsOnePixel) {
    const TestFolder folder;
    const Words words{"drop", "--frames", "1", "--size", "1x1", "--overlay", "--out", folder / "a"};
    EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
    EXPECT_EQ(read_png(folder / "a/frame_0001.png").rgb.size(), 3u);
}

TEST(Capture, SaysBeforeItSimulatesThatAFolderTakesNoFiles) {
    const TestFolder folder;
    const Outcome outcome = run_program("drape-capture", small("drop", {"--frames", "100000", "--out", "/proc/drape"}));
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("--out /proc/drape"));
}

TEST(Capture, SaysThatADiskIsFull) {
    const Outcome outcome = run_program("drape-capture", small("drop", {"--frames", "2", "--stats", "/dev/full"}));
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("/dev/full"));
}

TEST(Capture, KeepsThePicturesIfThereIsNoFfmpeg) {
    const TestFolder folder;
    const Words words = small("drop", {"--frames", "2", "--out", folder / "a", "--video", folder / "v.mp4"});
    const Outcome outcome = run_program("drape-capture", words, {"PATH=/nowhere"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("ffmpeg (Debian package ffmpeg) could not be started"));
    EXPECT_EQ(folder.names("a").size(), 2u);
}

TEST(Capture, KeepsThePicturesIfFfmpegDies) {
    const TestFolder folder;
    ASSERT_EQ(symlink("/bin/false", (folder / "ffmpeg").c_str()), 0);
    const Words words = small("drop", {"--frames", "4", "--out", folder / "a", "--video", folder / "v.mp4"});
    const Outcome outcome = run_program("drape-capture", words, {"PATH=" + folder / ""});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("ffmpeg failed with status 1"));
    EXPECT_EQ(folder.names("a").size(), 4u);
}

TEST(Capture, FeedsFfmpegWholeFrames) {
    const TestFolder folder;
    const std::string script = folder / "ffmpeg", raw = folder / "raw";
    std::ofstream(script) << "#!/bin/sh\ncat > " << raw << "\n";
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    Words words = small("drop", {"--frames", "2", "--out", folder / "a", "--video", folder / "v.mp4"});
    words[2] = "480x270";  // more than a pipe holds
    EXPECT_EQ(run_program("drape-capture", words, {"PATH=" + folder / "" + ":/bin:/usr/bin"}).exit_code, 0);
    std::string wanted;
    for (const std::string& name : folder.names("a")) {
        const Image image = read_png(folder / ("a/" + name));
        wanted.append(image.rgb.begin(), image.rgb.end());
    }
    EXPECT_TRUE(text_of(raw) == wanted);
}

TEST(Capture, FinishesItsFrameWhenItIsInterrupted) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TestFolder folder;
        const std::string stats = folder / "s.csv";
        const Words words = small("drop", {"--frames", "100000", "--out", folder / "a", "--stats", stats});
        EXPECT_EQ(interrupt_program("drape-capture", words, folder / "a/frame_000002.png", signal).exit_code,
                  128 + signal);
        const Words names = folder.names("a");
        EXPECT_EQ(table(stats).size(), names.size() + 1);
        EXPECT_EQ(read_png(folder / "a/" + names.back()).width, 160);
    }
}

TEST(Capture, EndsWithTheFramesKeptWhenTheStepIsUnstable) {
    const TestFolder folder;
    const Words unstable{"solver.dt=0.02", "solver.integrator=explicit_euler"};
    Words words = small("drop", {"--frames", "60", "--every", "1", "--out", folder / "a", "--set"});
    words.insert(words.end(), unstable.begin(), unstable.end());
    const Outcome stopped = run_program("drape-capture", words);
    EXPECT_EQ(stopped.exit_code, 1);
    EXPECT_THAT(stopped.err, HasSubstr("particle"));
    EXPECT_GT(folder.names("a").size(), 0u);
    EXPECT_LT(folder.names("a").size(), 60u);
}

TEST(Capture, EndsWithAPictureOfTheFailure) {
    const TestFolder folder;
    // In slow motion, as in the window: 4e-3 of real time
    const Words words{"fails_rk4", "--frames", "600", "--every", "100", "--size", "160x90", "--out", folder / "a"};
    const Outcome failed = run_program("drape-capture", words);
    EXPECT_EQ(failed.exit_code, 1);
    EXPECT_THAT(folder.names("a"), ElementsAre("frame_0100.png", "frame_0200.png", "frame_0300.png", "frame_0381.png",
                                               "unstable.csv", "unstable.toml"));
    EXPECT_THAT(failed.err, HasSubstr("frame_0381.png shows the last good state"));
    EXPECT_THAT(failed.err, testing::EndsWith("4 pictures in " + (folder / "a") + "\n"));
    EXPECT_NE(read_png(folder / "a/frame_0381.png").rgb, read_png(folder / "a/frame_0300.png").rgb);
}

TEST(Capture, RefusesToWriteNothing) {
    EXPECT_EQ(run_program("drape-capture", {"drop", "--frames", "2"}).exit_code, 2);
}

TEST(Capture, FollowsTheViewOfAReplay) {
    const TestFolder folder;
    std::ofstream(folder / "orbit.txt") << "drape-recording 1\nscene drop\n3 orbit 0.8 0.2\n100 end\n";
    std::ofstream(folder / "scene.txt") << "drape-recording 1\nscene drop\n3 scene hang\n100 end\n";
    std::ofstream(folder / "still.txt") << "drape-recording 1\nscene drop\n100 end\n";
    std::vector<Image> images;
    for (const std::string name : {"still", "orbit", "scene"}) {
        const Words words{"--replay",   folder / (name + ".txt"), "--frames", "1", "--size", "160x90", "--out",
                          folder / name};
        EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
        images.push_back(read_png(folder / (name + "/frame_0001.png")));
    }
    EXPECT_NE(images[0].rgb, images[1].rgb);
    EXPECT_NE(images[0].rgb, images[2].rgb);
}

TEST(Capture, DrawsThePanelOnlyIfItIsAskedTo) {
    const TestFolder folder;
    Words words{"drop", "--frames", "1", "--size", "640x480", "--out", folder / "a", "--set", "view.panel=full"};
    run_program("drape-capture", words);
    words[6] = folder / "b";
    words.emplace_back("--overlay");
    run_program("drape-capture", words);
    const Image without = read_png(folder / "a/frame_0001.png"), with = read_png(folder / "b/frame_0001.png");
    EXPECT_GT(without.pixel(12, 100)[1], 100);
    EXPECT_LT(with.pixel(12, 100)[1], 100);
    EXPECT_EQ(with.pixel(600, 400)[1], without.pixel(600, 400)[1]);
}

TEST(Capture, DrawsAPictureOfEachStopOfTheTour) {
    const TestFolder folder;
    EXPECT_EQ(run_program("drape-capture", {"--tour", "--size", "96x54", "--out", folder / "a"}).exit_code, 0);
    const std::vector<std::string> names = folder.names("a");
    ASSERT_EQ(names.size(), tour_stops().size());
    std::set<std::vector<std::uint8_t>> pictures;
    for (const std::string& name : names) pictures.insert(read_png(folder / ("a/" + name)).rgb);
    EXPECT_EQ(pictures.size(), names.size()) << "each is another";
    EXPECT_EQ(run_program("drape-capture", {"--tour"}).exit_code, 2);
}

}  // namespace
}  // namespace drape::test
