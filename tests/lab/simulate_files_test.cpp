#include <gmock/gmock.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>

#include "drape/sim/scene.h"
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

TEST(LabSimulate, SaysThatTheTimeIsMissing) {
    const LabFolder folder;
    EXPECT_THAT(folder.run({"simulate", "drop"}).err, StartsWith("drape-lab: --time is missing: say --time T"));
}

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

TEST(LabSimulate, RefusesEmptyWords) {
    const LabFolder folder;
    const std::vector<std::vector<std::string>> bad{{"simulate", "", "--time", "0"},
                                                    {"simulate", "drop", "--time", "0", "--state", ""},
                                                    {"simulate", "drop", "--time", "0", "--stats="},
                                                    {"simulate", "--replay", "", "--time", "0"}};
    for (const auto& words : bad) {
        const LabRun run = folder.run(words);
        EXPECT_EQ(run.code, 2) << testing::PrintToString(words);
        EXPECT_THAT(run.err, HasSubstr("allowed no empty name or value"));
    }
    folder.write("r.txt", "drape-recording 1\nscene \n9 end\n");
    EXPECT_THAT(folder.run({"simulate", "--replay", "r.txt"}).err, HasSubstr("r.txt:2: expected 'scene NAME'"));
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

TEST(LabSimulate, ShowsNoControlCharactersOfNames) {
    const LabFolder folder;
    const std::string odd = "a\x1b[31m\n.csv";
    const LabRun run = folder.run({"simulate", "hang", "--time", "0", "--state", "no/" + odd});
    EXPECT_EQ(run.code, 1);
    EXPECT_EQ(run.err.find('\x1b'), std::string::npos);
    EXPECT_EQ(lines_of(run.err).size(), 1u);
    EXPECT_THAT(run.err, HasSubstr("a\\x1b[31m\\n.csv"));
}

TEST(LabSimulate, RefusesAnOptionInThePlaceOfAValue) {
    const LabFolder folder;
    const std::vector<std::vector<std::string>> bad{{"stability", "--out", "--quick"},
                                                    {"simulate", "--time", "--hash", "drop"},
                                                    {"simulate", "drop", "--time", "0", "--set", "--hash"},
                                                    {"collide", "--grid", "--positions", "x.csv"},
                                                    {"needs", "drop", "--set", "--out"}};
    for (const auto& words : bad) {
        const LabRun run = folder.run(words);
        EXPECT_EQ(run.code, 2) << words[0];
        EXPECT_THAT(run.err, HasSubstr(" needs a value, and '--")) << words[0];
        EXPECT_LE(lines_of(run.err).size(), 2u);
    }
    EXPECT_FALSE(folder.has("--quick"));
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

TEST(LabSimulate, SaysNoMoreThanTwoLinesOfAnyInput) {
    const LabFolder folder;
    const std::string endless(50'000, 'x'), lines = "a\nb\nc\nd";
    folder.write("bad.toml", "title = \"x\"\n[cloth]\npinned = \"a\\nb\\nc\\n\"\n");
    const std::vector<std::vector<std::string>> bad{
        {"simulate", lines, "--time", "0"},
        {"simulate", "drop", "--time", lines},
        {"simulate", "drop", "--time", endless},
        {"simulate", "drop", "--set", "dt=" + lines, "--time", "0"},
        {"simulate", "drop", "--set", lines + "=1", "--time", "0"},
        {"simulate", "drop", "--set", "title=" + lines, "--time", "0"},
        {"simulate", "drop", "--set", "start=" + lines, "--time", "0"},
        {"simulate", "drop", "--time", "0", "--" + lines},
        {"simulate", "bad.toml", "--time", "0"},
        {"simulate", lines + ".toml", "--time", "0"},
        {"simulate", "--replay", lines},
        {"collide", "--grid", lines, "--ball", "0,0,0,1", "--positions", "x"},
        {lines}};
    for (const auto& words : bad) {
        const LabRun run = folder.run(words);
        EXPECT_EQ(run.code, 2) << testing::PrintToString(words);
        EXPECT_LE(lines_of(run.err).size(), 2u) << run.err;
        EXPECT_LT(run.err.size(), 1000u);
    }
}

TEST(LabSimulate, EndsWithTwoAndTheRangeOnBadInput) {
    const LabFolder folder;
    const auto refused = [&](const std::vector<std::string>& words) {
        const LabRun run = folder.run(words);
        EXPECT_EQ(run.code, 2) << testing::PrintToString(words);
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_LE(lines_of(run.err).size(), 2u) << run.err;
        EXPECT_THAT(run.err, StartsWith("drape-lab: "));
        return run.err;
    };
    EXPECT_THAT(refused({"simulate", "drop", "--time", "1", "--set", "dt=5"}),
                AllOf(HasSubstr("--set dt=5"), HasSubstr("allowed 1e-09 <= dt <= 0.1 s")));
    EXPECT_THAT(refused({"simulate", "dorp", "--time", "1"}), HasSubstr("did you mean 'drop'?"));
    EXPECT_THAT(refused({"simulate", "drop", "--time", "nan"}), HasSubstr("--time nan"));
    for (const char* time : {"", "-1", "inf", "1,", "2,1", "x", "1e9"}) refused({"simulate", "drop", "--time", time});
    EXPECT_THAT(refused({"simulate", "drop"}), HasSubstr("--time"));
    folder.write("bad.toml", "[cloth]\nmass = 0\n");
    EXPECT_THAT(refused({"simulate", "bad.toml", "--time", "1"}), HasSubstr("bad.toml:2:8: cloth.mass = 0: allowed"));
    refused({"simulate", "drop", "--time", "1", "--replay", "none.txt"});
    refused({"simulate", "drop", "--time", "1", "--nonsense"});
    refused({});
    refused({"nonsense"});
}

TEST(LabSimulate, EndsWithOneWhenItsOutputCannotBeWritten) {
    const LabFolder folder;
    const LabRun run = folder.run({"simulate", "drop", "--time", "1e5", "--state", "no/such/folder.csv"});
    EXPECT_EQ(run.code, 1) << "found before simulating";
    EXPECT_THAT(run.err, HasSubstr("no/such/folder.csv"));
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no device that is always full";
    EXPECT_EQ(folder.run({"simulate", "drop", "--time", "0", "--stats", "/dev/full"}).code, 1);
}

TEST(LabSimulate, RefusesOneFileForStateAndStats) {
    const LabFolder folder;
    const LabRun run = folder.run({"simulate", "drop", "--time", "0", "--state", "a.csv", "--stats", "./a.csv"});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("--state a.csv and --stats ./a.csv, the same file: allowed two different files"));
    EXPECT_EQ(folder.run({"simulate", "drop", "--time", "0", "--state", "/dev/null", "--stats", "/dev/null"}).code, 0);
}

TEST(LabSimulate, WritesNoFileThatItReads) {
    const LabFolder folder;
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
    refused({"simulate", "scene.toml", "--time", "0", "--state", "./scene.toml"}, "SCENE scene.toml and --state",
            "scene.toml");
    refused({"simulate", "scene.toml", "--time", "0", "--stats", "start.csv"}, "start = ", "start.csv");
    refused({"simulate", "--replay", "r.txt", "--state", "./r.txt"}, "--replay r.txt and --state ./r.txt", "r.txt");
    refused({"simulate", "--replay", "r.txt", "--stats", "hard.txt"}, "--replay r.txt and --stats hard.txt", "r.txt");
}

TEST(LabSimulate, IsEndedByASignalWithTheTimesThatItHasPassed) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const LabFolder folder;
        test::Process run({DRAPE_LAB, "simulate", "hang", "--time", "0,1e5", "--state", "state.csv"}, {},
                          folder.path());
        ASSERT_TRUE(test::eventually([&] { return folder.has(".state.drape-0.csv"); }));
        run.send(signal);
        EXPECT_EQ(run.wait(60), 128 + signal);
        EXPECT_GT(lines_of(folder.read("state.csv")).size(), 100u);
        EXPECT_FALSE(folder.has(".state.drape-0.csv"));
    }
}

TEST(LabSimulate, LeavesTheFileOfBeforeIfItReachesNoTime) {
    const LabFolder folder;
    folder.write("state.csv", "before");
    test::Process run({DRAPE_LAB, "simulate", "hang", "--time", "1e5", "--state", "state.csv"}, {}, folder.path());
    ASSERT_TRUE(test::eventually([&] { return folder.has(".state.drape-0.csv"); }));
    EXPECT_EQ(folder.read("state.csv"), "before");
    run.send(SIGTERM);
    EXPECT_EQ(run.wait(60), 128 + SIGTERM);
    EXPECT_EQ(folder.read("state.csv"), "before");
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
