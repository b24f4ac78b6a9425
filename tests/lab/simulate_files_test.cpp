#include <gmock/gmock.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>

#include "drape/scene/scene.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::lines_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(LabSimulate, RefusesTimesBetweenWhichNoStepEnds) {
    const LabFolder folder;
    const auto run = [&](const std::string& times) {
        return folder.run({"simulate", "hang", "--set", "dt=0.1", "cloth.particles=2,2", "sleep_speed=0", "--state",
                           "state.csv", "--time", times});
    };
    for (const char* times : {"0.05", "0.01,0.02,0.03", "0.1,0.15"}) {
        EXPECT_EQ(run(times).code, 2) << times;
        EXPECT_FALSE(folder.has("state.csv"));
    }
    EXPECT_THAT(run("0.2,0.25").err, AllOf(HasSubstr("--time 0.25: no step ends after 0.2 s"), HasSubstr("0.1 s")));
    const LabRun within = run("0,0.1,0.25");
    EXPECT_EQ(within.code, 0) << within.err;
    EXPECT_THAT(within.err, HasSubstr("warning: --time 0.25 is within a step: the state is that before it, at 0.2 s"));
    EXPECT_THAT(run("0.1,0.2,0.3").err, testing::Not(HasSubstr("within"))) << "but for rounding";
    folder.write("r.txt", "drape-recording 1\nscene hang\nset cloth.particles=2,2\nset dt=0.1\n1 set dt=0.01\n9 end\n");
    EXPECT_EQ(folder.run({"simulate", "--replay", "r.txt", "--time", "0.11,0.12"}).code, 0) << "steps become shorter";
}

TEST(LabSimulate, TakesASceneThatStartsFromItsOwnFolderOnly) {
    const LabFolder folder;
    std::filesystem::create_directory(folder.path("below"));
    folder.write("start.csv",
                 "t,particle,x,y,z,vx,vy,vz\n0,0,0,0,0,0,0,0\n0,1,1,0,0,0,0,0\n0,2,0,0,1,0,0,0\n0,3,1,0,1,0,0,0\n");
    const std::string pipe = folder.path("pipe.csv");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/stdin", folder.path("link.csv"));
    const auto run = [&](const std::string& scene, const std::string& start) {
        folder.write(scene, "start = \"" + start + "\"\n[cloth]\nparticles = [2, 2]\n");
        return folder.run({"simulate", scene, "--time", "0"});
    };
    EXPECT_EQ(run("s.toml", "start.csv").code, 0);
    EXPECT_EQ(run("s.toml", "below/../start.csv").code, 0);
    for (const char* start : {"/dev/stdin", "/etc/passwd", "../start.csv", "link.csv"}) {
        const LabRun refused = run("below/s.toml", start == std::string("link.csv") ? "../link.csv" : start);
        EXPECT_EQ(refused.code, 2);
        EXPECT_THAT(refused.err, HasSubstr("s.toml:1:9: start = "));
        EXPECT_THAT(refused.err, HasSubstr("allowed only a file in the scene's folder or below"));
    }
    EXPECT_THAT(run("s.toml", "link.csv").err, HasSubstr("start = "));
    EXPECT_THAT(run("s.toml", "pipe.csv").err, HasSubstr("is a pipe: allowed a regular file"));
    EXPECT_THAT(folder.run({"simulate", "drop", "--time", "0", "--set", "start=/dev/stdin"}).err,
                HasSubstr("allowed a regular file"));
}

TEST(LabSimulate, NeverWaitsForAFileThatIsNone) {
    const LabFolder folder;
    const std::string pipe = folder.path("pipe.toml");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::vector<std::vector<std::string>> runs{
        {"simulate", "--time", "0", "@"},
        {"simulate", "--time", "0", "--replay", "@"},
        {"simulate", "--time", "0", "drop", "--set", "start=@"},
        {"collide", "--grid", "2x2", "--ball", "0,0,0,1", "--positions", "@"}};
    const std::vector<std::pair<std::string, std::string>> files{
        {pipe, "is a pipe"}, {folder.path().string() + "/", "is a folder"}, {"/dev/zero", "is a device"}};
    for (auto words : runs) {
        for (const auto& [file, what] : files) {
            std::vector<std::string> named = words;
            for (std::string& word : named) {
                if (word.ends_with('@')) word.replace(word.size() - 1, 1, file);
            }
            const LabRun run = folder.run(named);
            EXPECT_EQ(run.code, 2) << testing::PrintToString(named);
            EXPECT_THAT(run.err, HasSubstr(file + ": " + what));
        }
    }
}

TEST(LabSimulate, EndsWithTwoAndTheRangeOnBadInput) {
    const LabFolder folder;
    folder.write("bad.toml", "[cloth]\nmass = 0\n");
    folder.write("lines.toml", "title = \"x\"\n[cloth]\npinned = \"a\\nb\\nc\\n\"\n");
    folder.write("r.txt", "drape-recording 1\nscene \n9 end\n");
    const std::string lines = "a\nb\nc\nd", is_empty = "allowed no empty name or value",
                      is_option = " needs a value, and '--";
    const std::vector<std::pair<std::vector<std::string>, std::string>> bad{
        {{"simulate", "drop"}, "--time is missing: say --time T"},
        {{"simulate", "drop", "--time", "1", "--set", "dt=5"},
         "--set dt=5: solver.dt = 5: allowed 1e-09 <= dt <= 0.1 s"},
        {{"simulate", "dorp", "--time", "1"}, "did you mean 'drop'?"},
        {{"simulate", "drop", "--time", "nan"}, "--time nan"},
        {{"simulate", "bad.toml", "--time", "1"}, "bad.toml:2:8: cloth.mass = 0: allowed"},
        {{"simulate", "--replay", "r.txt"}, "r.txt:2: expected 'scene NAME'"},
        {{"simulate", "drop", "--time", "1", "--replay", "none.txt"}, ""},
        {{"simulate", "drop", "--time", "1", "--nonsense"}, ""},
        {{}, ""},
        {{"nonsense"}, ""},
        {{"simulate", "", "--time", "0"}, is_empty},
        {{"simulate", "drop", "--time", "0", "--state", ""}, is_empty},
        {{"simulate", "drop", "--time", "0", "--stats="}, is_empty},
        {{"simulate", "--replay", "", "--time", "0"}, is_empty},
        {{"stability", "--out", "--quick"}, is_option},
        {{"simulate", "drop", "--time", "0", "--set", "--hash"}, is_option},
        {{"collide", "--grid", "--positions", "x.csv"}, is_option},
        {{"needs", "drop", "--set", "--out"}, is_option},
        // Of any input no more than two lines are said
        {{"simulate", lines, "--time", "0"}, ""},
        {{"simulate", lines + ".toml", "--time", "0"}, ""},
        {{"simulate", "lines.toml", "--time", "0"}, "lines.toml"},
        {{"simulate", "drop", "--time", lines}, "--time"},
        {{"simulate", "drop", "--time", std::string(50'000, 'x')}, "--time"},
        {{"simulate", "drop", "--set", "dt=" + lines, "--time", "0"}, "dt"},
        {{"simulate", "drop", "--set", lines + "=1", "--time", "0"}, ""},
        {{"simulate", "drop", "--set", "title=" + lines, "--time", "0"}, ""},
        {{"simulate", "drop", "--set", "start=" + lines, "--time", "0"}, ""},
        {{"simulate", "drop", "--time", "0", "--" + lines}, ""},
        {{"simulate", "--replay", lines}, ""},
        {{"collide", "--grid", lines, "--ball", "0,0,0,1", "--positions", "x"}, "--grid"},
        {{lines}, ""}};
    for (const auto& [words, said] : bad) {
        const LabRun run = folder.run(words);
        EXPECT_EQ(run.code, 2) << testing::PrintToString(words);
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_LE(lines_of(run.err).size(), 2u) << run.err;
        EXPECT_LT(run.err.size(), 1000u);
        EXPECT_THAT(run.err, AllOf(StartsWith("drape-lab: "), HasSubstr(said)));
    }
    for (const char* time : {"", "-1", "inf", "1,", "2,1", "1e9"}) {
        EXPECT_EQ(folder.run({"simulate", "drop", "--time", time}).code, 2) << time;
    }
    EXPECT_FALSE(folder.has("--quick"));
}

TEST(LabSimulate, EndsWithOneWhenItsOutputCannotBeWritten) {
    const LabFolder folder;
    const std::string odd = "no/a\x1b[31m\n.csv";
    const LabRun run = folder.run({"simulate", "drop", "--time", "1e5", "--state", odd});
    EXPECT_EQ(run.code, 1) << "found before simulating";
    EXPECT_THAT(run.err, HasSubstr("no/a\\x1b[31m\\n.csv"));
    EXPECT_EQ(run.err.find('\x1b'), std::string::npos);
    EXPECT_EQ(lines_of(run.err).size(), 1u);
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no device that is always full";
    EXPECT_EQ(folder.run({"simulate", "drop", "--time", "0", "--stats", "/dev/full"}).code, 1);
}

TEST(LabSimulate, WritesNoFileTwiceAndNoneThatItReads) {
    const LabFolder folder;
    EXPECT_EQ(folder.run({"simulate", "drop", "--time", "0", "--state", "/dev/null", "--stats", "/dev/null"}).code, 0);
    ASSERT_EQ(folder.run({"simulate", "hang", "--time", "0", "--state", "start.csv"}).code, 0);
    folder.write("r.txt", "drape-recording 1\nscene hang\n9 end\n");
    folder.write("scene.toml", "start = \"start.csv\"\n" + test::read_file(scene_file("hang")));
    std::filesystem::create_hard_link(folder.path("r.txt"), folder.path("hard.txt"));
    const auto refused = [&](const std::vector<std::string>& words, const std::string& said, const std::string& file) {
        const std::string before = folder.read(file);
        const LabRun run = folder.run(words);
        EXPECT_EQ(run.code, 2) << said;
        EXPECT_THAT(run.err, AllOf(HasSubstr(said), HasSubstr("allowed two different files")));
        EXPECT_EQ(folder.read(file), before) << said;
    };
    refused({"simulate", "drop", "--time", "0", "--state", "a.csv", "--stats", "./a.csv"},
            "--state a.csv and --stats ./a.csv, the same file", "a.csv");
    refused({"simulate", "scene.toml", "--time", "0", "--state", "./scene.toml"}, "SCENE scene.toml and --state",
            "scene.toml");
    refused({"simulate", "scene.toml", "--time", "0", "--stats", "start.csv"}, "start = ", "start.csv");
    refused({"simulate", "--replay", "r.txt", "--state", "./r.txt"}, "--replay r.txt and --state ./r.txt", "r.txt");
    refused({"simulate", "--replay", "r.txt", "--stats", "hard.txt"}, "--replay r.txt and --stats hard.txt", "r.txt");
}

TEST(LabSimulate, IsEndedByASignalWithTheTimesThatItHasPassed) {
    const LabFolder folder;
    folder.write("state.csv", "before");
    const auto signalled = [&](const std::string& times, int signal) {
        test::Process run({DRAPE_LAB, "simulate", "hang", "--time", times, "--state", "state.csv"}, {}, folder.path());
        EXPECT_TRUE(test::eventually([&] { return folder.has(".state.drape.csv"); }));
        run.send(signal);
        EXPECT_EQ(run.wait(60), 128 + signal);
        EXPECT_FALSE(folder.has(".state.drape.csv"));
        return folder.read("state.csv");
    };
    EXPECT_EQ(signalled("1e5", SIGTERM), "before") << "it has reached no time";
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) EXPECT_GT(lines_of(signalled("0,1e5", signal)).size(), 100u);
}

TEST(LabSimulate, FailsWhereAFileGrowsBeyondWhatIsAllowed) {
    const LabFolder folder;
    folder.write("state.csv", "before");
    const std::string command =
        std::string("ulimit -f 8; exec ") + DRAPE_LAB + " simulate hang --time 0 --state state.csv";
    const LabRun run = folder.run({"-c", command}, "sh");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("state.csv: could not be written whole: File too large"));
    EXPECT_EQ(folder.read("state.csv"), "before");
}

}  // namespace
}  // namespace drape
