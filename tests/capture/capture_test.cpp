#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "drape/base/commit.h"
#include "drape/render/image.h"
#include "drape/render/renderer.h"
#include "drape/sim/step_report.h"
#include "program.h"
#include "support/read_png.h"

namespace drape::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A run of a few small frames.
Words small(const std::string& scene, const Words& more) {
    return joined({scene, "--size", "160x90", "--fps", "120"}, more);
}

std::vector<Words> table(const std::string& file) {
    std::vector<Words> rows;
    std::stringstream in(read_file(file));
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#')) continue;
        Words& row = rows.emplace_back();
        std::stringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    }
    return rows;
}

TEST(Capture, DrawsEverySoManiethFrame) {
    const TestFolder folder;
    const Words words = small("drop", {"--frames", "7", "--every", "3", "--out", folder / "a/b"});
    const Outcome run = run_program("drape-capture", words);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_THAT(folder.names("a/b"), ElementsAre("frame_0003.png", "frame_0006.png"));
    EXPECT_EQ(read_png(folder / "a/b/frame_0003.png").width, 160);
    EXPECT_THAT(run.err, testing::EndsWith("2 pictures in " + (folder / "a/b") + "\n"));
}

TEST(Capture, ReachesTheSameStateAsTheLab) {
    const TestFolder folder;
    const std::string ours = folder / "a.csv", labs = folder / "b.csv";
    const Outcome lab = run_program("drape-lab", {"simulate", "curtain", "--time", "0.25", "--hash", "--state", labs});
    const Words hash{"curtain", "--frames", "15", "--fps", "60", "--hash", "--state", ours};
    EXPECT_EQ(run_program("drape-capture", hash).out, lab.out);
    EXPECT_EQ(read_file(ours), read_file(labs));
    EXPECT_GT(read_file(ours).size(), 1000u);
    const Words drawn = joined(hash, {"--size", "64x36", "--out", folder / "a", "--every", "5", "--overlay"});
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
    for (const FrameField& field : frame_fields) wanted.emplace_back(field.name);
    for (const BallField& field : ball_fields()) wanted.emplace_back("ball0_" + std::string(field.name));
    EXPECT_EQ(rows[0], wanted);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].size(), wanted.size());
        EXPECT_EQ(rows[i][0], std::to_string(2 * i));
    }
    EXPECT_THAT(read_file(file), testing::StartsWith("# units: time [s], step_limit_ratio [1], "));
    for (const FrameField& field : frame_fields) {
        if (field.unit.empty()) continue;
        EXPECT_THAT(read_file(file), HasSubstr(", " + std::string(field.name) + " [" + std::string(field.unit) + "]"));
    }
}

TEST(Capture, CountsItsFramesFromTheStartOfTheScene) {
    const TestFolder folder;
    const std::string start = folder / "start.csv", end = folder / "end.csv";
    const auto run = [&](const Words& words) {
        return run_program("drape-capture", joined({"two_corners", "--set", "sleep_speed=0"}, words));
    };
    run({"--frames", "6", "--state", start});
    const Outcome whole = run({"--frames", "9", "--hash"});
    const Outcome rest = run({"start=" + start, "--frames", "3", "--hash", "--state", end});
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(rest.out, whole.out);
    EXPECT_NEAR(std::stod(table(end).at(1).at(0)), 0.15, 1e-12);
}

TEST(Capture, GoesOnFromASnapshotOfTheLaboratoryWhichGoesOnFromItsOwn) {
    const TestFolder folder;
    const std::string first = folder / "first.snapshot", second = folder / "second.snapshot";
    EXPECT_EQ(run_program("drape-lab", {"simulate", "trampoline", "--time", "0.4", "--save", first}).exit_code, 0);
    const Outcome middle = run_program(
        "drape-capture", {"--load", first, "--frames", "6", "--fps", "60", "--out", folder / "out", "--save", second});
    EXPECT_EQ(middle.exit_code, 0) << middle.err;
    const Outcome end = run_program("drape-lab", {"simulate", "--load", second, "--time", "0.6", "--hash"});
    EXPECT_EQ(end.exit_code, 0) << end.err;
    EXPECT_EQ(end.out, run_program("drape-lab", {"simulate", "trampoline", "--time", "0.6", "--hash"}).out);
    const Outcome early = run_program("drape-lab", {"simulate", "--load", second, "--time", "0.45"});
    EXPECT_THAT(early.err, HasSubstr("for the scene starts at t = 0.5 s"));
    const Outcome same = run_program("drape-capture", {"--load", first, "--frames", "1", "--save", first});
    EXPECT_THAT(same.err, HasSubstr("--load and --save " + first));
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

/// The greatest number in a column of the figures of frames, but for the first, which also sends what stays the same.
double most_of(const std::string& file, const std::string& name) {
    const std::vector<Words> rows = table(file);
    const auto column = std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin();
    double most = 0;
    for (std::size_t i = 2; i < rows.size(); ++i)
        most = std::max(most, std::stod(rows[i][static_cast<std::size_t>(column)]));
    return most;
}

TEST(Capture, DrawsFastOnlyWhereItIsTold) {
    const TestFolder folder;
    const auto draw = [&](const std::string& quality) {
        const Words words{"--frames", "1", "--out", folder / quality, "--set", "view.quality=" + quality};
        EXPECT_EQ(run_program("drape-capture", small("hang", words)).exit_code, 0);
        return read_png(folder / (quality + "/frame_0001.png")).rgb;
    };
    const std::vector<std::uint8_t> full = draw("full");
    EXPECT_TRUE(full == draw("auto")) << "a capture has time";
    EXPECT_TRUE(full != draw("fast"));
}

TEST(Capture, NeedsAtMostSixtyCallsForThePictureAndFewForPanels) {
    const TestFolder folder;
    const std::string file = folder / "s.csv";
    const auto calls = [&](const Words& shown) {
        const Words words{"drop",    "--size", "640x360", "--frames",         "20",
                          "--every", "10",     "--out",   folder / "a",       "--again",
                          "--stats", file,     "--set",   "view.bounds=true", "view.level=2"};
        EXPECT_EQ(run_program("drape-capture", joined(words, shown)).exit_code, 0);
        EXPECT_EQ(table(file).size(), 3u);
        return most_of(file, "gl_calls");
    };
    const double picture = calls({"view.contacts=true", "view.particles=true", "view.wireframe=true"});
    EXPECT_LE(picture, 60);
    EXPECT_GT(picture, 40) << "less than all of it can need";
    const double plain = calls({});
    const double figures = calls({"view.panel=full", "view.plots=true", "--overlay"});
    const double settings = calls({"view.panel=full", "view.plots=true", "view.controls=true", "--overlay"});
    EXPECT_GT(figures, plain) << "panels are drawn";
    EXPECT_LE(figures - plain, 6) << "figures, plots and the table of the hierarchy are one draw call";
    EXPECT_GT(settings, figures);
    EXPECT_LE(settings - figures, 12) << "the settings scroll in a window of their own";
}

TEST(Capture, RefusesBadOptionsWithWhatIsAllowed) {
    for (const auto& [words, said] : std::vector<std::pair<Words, std::string>>{
             {{"--frames", "0"}, "--frames 0: allowed 1 to"},
             {{"drop", "--frames", "2"}, "nothing to write"},
             {{"drop", "--frames", "1", "--out", "--hash"}, "--out needs a value, and '--hash' is an option"},
             {{"--tour"}, "--tour needs --out"},
             {{"--frames", "two"}, "--frames two"},
             {{"--frames", "1", "--size", "0x5"}, "--size 0x5: allowed WxH, 1 to 8192 each"},
             {{"--frames", "1", "--size", "9000x5"}, "--size 9000x5"},
             {{"--frames", "1", "--size", "12"}, "--size 12"},
             {{"--frames", "1", "--fps", "nan"}, "--fps nan"},
             {{"--frames", "2", "--every", "3"}, "--every 3"},
             {{"drop", "--hash", "--frames", "1", "--context", "glx"}, "--context: glx not in {auto,osmesa,egl}"},
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
    const Words words{"drop", "--frames", "1", "--fps", "120", "--size", "1x1", "--overlay", "--out", folder / "a"};
    run_program("drape-capture", joined(words, {"--set", "dt=1e-4"}));
    EXPECT_EQ(read_png(folder / "a/frame_0001.png").rgb.size(), 3u) << "one pixel";
    const std::string bytes = read_file(folder / "a/frame_0001.png");
    const auto chunk = [](const std::string& keyword, const std::string& text) {
        return "iTXt" + keyword + std::string(5, '\0') + text;
    };
    EXPECT_THAT(bytes, HasSubstr(chunk("Commit", commit())));
    EXPECT_THAT(bytes, HasSubstr(chunk("Scene", "drop")));
    EXPECT_THAT(bytes, HasSubstr(chunk("Time", "0.0083 s")));
    EXPECT_THAT(bytes, HasSubstr("dt = 1e-04"));
}

TEST(Capture, FeedsFfmpegWholeFrames) {
    const TestFolder folder;
    put_ffmpeg(folder, "for last; do :; done\ntee \"$last\" > " + (folder / "raw") + "\n");
    Words words = small("drop", {"--frames", "2", "--out", folder / "a", "--video", folder / "v.mp4"});
    words[2] = "480x270";  // more than a pipe holds
    EXPECT_EQ(run_program("drape-capture", words, path_from(folder)).exit_code, 0);
    std::string wanted;
    for (const std::string& name : folder.names("a")) {
        const Image image = read_png(folder / ("a/" + name));
        wanted.append(image.rgb.begin(), image.rgb.end());
    }
    EXPECT_TRUE(read_file(folder / "raw") == wanted);
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

TEST(Capture, FollowsTheViewOfAReplay) {
    const TestFolder folder;
    std::vector<Image> images;
    for (const char* command : {"", "3 orbit 0.8 0.2\n", "3 scene hang\n"}) {
        std::ofstream(folder / "r.txt") << "drape-recording 1\nscene drop\n" << command << "100 end\n";
        const Words words{"--replay", folder / "r.txt", "--frames", "1", "--size", "160x90", "--out", folder / "a"};
        EXPECT_EQ(run_program("drape-capture", joined(words, {"--again"})).exit_code, 0);
        images.push_back(read_png(folder / "a/frame_0001.png"));
    }
    EXPECT_NE(images[0].rgb, images[1].rgb);
    EXPECT_NE(images[0].rgb, images[2].rgb);
}

}  // namespace
}  // namespace drape::test
