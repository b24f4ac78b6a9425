#include <gmock/gmock.h>
#include <sys/stat.h>

#include <array>

#include <csignal>

#include "drape/base/numbers.h"
#include "drape/sim/scene.h"
#include "drape/sim/session.h"
#include "drape/sim/step_report.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::lines_of;
using test::table_of;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::StartsWith;

/// The text of a shipped scene.
std::string read_scene(const std::string& name) { return test::read_file(scene_file(name)); }

/// The values of one row of a CSV file.
std::vector<double> values_of(const std::string& row) {
    std::vector<double> values;
    for (std::size_t begin = 0; begin <= row.size();) {
        const std::size_t comma = std::min(row.find(',', begin), row.size());
        values.push_back(parse_real(row.substr(begin, comma - begin)).value());
        begin = comma + 1;
    }
    return values;
}

TEST(LabSimulate, PrintsTheHashOfTheSameStateAsTheLibrary) {
    const LabFolder folder;
    const LabRun run = folder.run({"simulate", "drop", "--time", "0.05", "--hash"});
    Session session(Simulation("drop", load_scene("drop")));
    session.run_until(0.05);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.out, hash_text(session.simulation().hash()) + "\n");
    EXPECT_THAT(run.err, StartsWith(std::to_string(session.simulation().report().step) + " steps to 0.05 s in "));
}

TEST(LabSimulate, TakesSettingsAnywhereAndManyAtATime) {
    const LabFolder folder;
    const std::string hash = folder.run({"simulate", "drop", "--time", "0.05", "--hash"}).out;
    const std::vector<std::vector<std::string>> same{
        {"simulate", "--set", "volume=brute", "leaf_cells=2", "--time=0.02,0.05", "--hash", "drop"},
        {"simulate", "drop", "--set", "volume=brute", "--set", "leaf_cells=1", "--time", "0.05", "--hash"},
        {"simulate", "--time", "0.05", "--hash", "--set", "volume=brute", "drop"}};
    for (const auto& words : same) EXPECT_EQ(folder.run(words).out, hash);
    EXPECT_NE(folder.run({"simulate", "drop", "--time", "0.05", "--hash", "--set", "cloth.mass=0.3"}).out, hash);
}

TEST(LabSimulate, WritesEveryParticleAtEveryTimeSoThatItReadsBack) {
    const LabFolder folder;
    ASSERT_EQ(folder.run({"simulate", "drop", "--time", "0,0.05", "--state", "state.csv"}).code, 0);
    const auto lines = lines_of(folder.read("state.csv"));
    ASSERT_EQ(lines.size(), 1u + 2 * 900);
    EXPECT_EQ(lines[0], "t,particle,x,y,z,vx,vy,vz");
    Session session(Simulation("drop", load_scene("drop")));
    session.run_until(0.05);
    const ClothState& state = session.simulation().cloths()[0].state;
    for (int p = 0; p < 900; ++p) {
        const std::vector<double> row = values_of(lines[static_cast<std::size_t>(901 + p)]);
        EXPECT_EQ(row, (std::vector<double>{row[0], static_cast<double>(p), state.x(p, 0), state.x(p, 1), state.x(p, 2),
                                            state.v(p, 0), state.v(p, 1), state.v(p, 2)}));
        EXPECT_DOUBLE_EQ(row[0], 0.05);
    }
    EXPECT_EQ(values_of(lines[1])[0], 0);
}

TEST(LabSimulate, NamesTheClothWhereThereAreSeveral) {
    const LabFolder folder;
    folder.write("two.toml", "[[cloth]]\nparticles = [2, 2]\n[[cloth]]\nparticles = [3, 2]\n");
    ASSERT_EQ(folder.run({"simulate", "two.toml", "--time", "0", "--state", "state.csv"}).code, 0);
    const auto lines = lines_of(folder.read("state.csv"));
    ASSERT_EQ(lines.size(), 1u + 4 + 6);
    EXPECT_EQ(lines[0], "t,cloth,particle,x,y,z,vx,vy,vz");
    EXPECT_THAT(lines[4], StartsWith("0,0,3,"));
    EXPECT_THAT(lines[5], StartsWith("0,1,0,"));
}

TEST(LabSimulate, WritesEveryFieldOfTheReport) {
    const LabFolder folder;
    ASSERT_EQ(folder.run({"simulate", "curtain", "--time", "0.01,0.02", "--stats", "stats.csv"}).code, 0);
    EXPECT_EQ(lines_of(folder.read("stats.csv")).size(), 4u);
    const auto lines = table_of(folder, "stats.csv");
    ASSERT_EQ(lines.size(), 3u);
    std::string header;
    for (const ReportField& field : report_fields()) header += (header.empty() ? "" : ",") + std::string(field.name);
    EXPECT_EQ(lines[0], header);
    EXPECT_EQ(values_of(lines[2]).size(), report_fields().size());
    EXPECT_NEAR(values_of(lines[2])[0], 0.02 / static_cast<double>(load_scene("curtain").solver.dt), 1e-6);
    EXPECT_DOUBLE_EQ(values_of(lines[2])[1], 0.02);
}

TEST(LabSimulate, GivesTheUnitsOfItsReport) {
    const LabFolder folder;
    ASSERT_EQ(folder.run({"simulate", "curtain", "--time", "0", "--stats", "stats.csv"}).code, 0);
    const std::string units = lines_of(folder.read("stats.csv"))[0];
    EXPECT_THAT(units, StartsWith("# units: time [s], step_limit_ratio [1], residual [1], "));
    for (const ReportField& field : report_fields()) {
        const std::string unit = std::string(field.name) + " [" + std::string(field.unit) + "]";
        EXPECT_EQ(units.find(" " + unit) != std::string::npos, !field.unit.empty()) << field.name;
    }
}

TEST(LabSimulate, StopsAtTimesOfASceneThatStartsLater) {
    const LabFolder folder;
    const std::vector<std::string> awake{"simulate", "two_corners", "--set", "sleep_speed=0", "--hash"};
    const auto run = [&](std::vector<std::string> words) {
        words.insert(words.begin(), awake.begin(), awake.end());
        return folder.run(words);
    };
    ASSERT_EQ(run({"--time", "0.1", "--state", "start.csv"}).code, 0);
    const LabRun whole = run({"--time", "0.15"});
    const LabRun rest = run({"--set", "start=start.csv", "--time", "0.1,0.15", "--state", "end.csv"});
    ASSERT_EQ(rest.code, 0) << rest.err;
    EXPECT_EQ(rest.out, whole.out);
    const auto lines = lines_of(folder.read("end.csv"));
    EXPECT_DOUBLE_EQ(values_of(lines[1])[0], 0.1);
    EXPECT_DOUBLE_EQ(values_of(lines.back())[0], 0.15);
    const LabRun early = run({"--set", "start=start.csv", "--time", "0.05"});
    EXPECT_EQ(early.code, 2);
    EXPECT_THAT(early.err, HasSubstr("--time 0.05: allowed 0.1 <= T <= 1000000.1 s, for the scene starts at t = 0.1"));
}

TEST(LabSimulate, SaysThatTheTimeIsMissing) {
    const LabFolder folder;
    EXPECT_THAT(folder.run({"simulate", "drop"}).err, StartsWith("drape-lab: --time is missing: say --time T"));
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

TEST(LabSimulate, FailsAndSaysWhatLostTheCloth) {
    const LabFolder folder;
    const LabRun lost = folder.run({"simulate", "drop", "--time", "0,5,6", "--hash", "--state", "state.csv", "--set",
                                    "dt=0.05", "integrator=explicit_euler"});
    EXPECT_EQ(lost.code, 1);
    EXPECT_THAT(lost.err, AllOf(HasSubstr("particle "), HasSubstr("of explicit_euler")));
    EXPECT_EQ(lost.out.size(), 17u) << "the hash of the last good state";
    EXPECT_EQ(lines_of(folder.read("state.csv")).size(), 1u + 900u) << "no rows for times that were never reached";
}

TEST(LabSimulate, MarksARunThatItsMethodHasHeatedOrEndsIt) {
    const LabFolder folder;
    const std::vector<std::string> words{
        "simulate",        "two_corners",           "--time",  "1",
        "--set",           "cloth.particles=16,16", "dt=0.05", "integrator=implicit_midpoint",
        "on_unstable=warn"};
    const LabRun marked = folder.run(words);
    EXPECT_EQ(marked.code, 0);
    EXPECT_THAT(marked.err, HasSubstr("warning: implicit_midpoint has made"));
    std::vector<std::string> stopping = words;
    stopping.back() = "on_unstable=stop";
    const LabRun stopped = folder.run(stopping);
    EXPECT_EQ(stopped.code, 1);
    EXPECT_THAT(stopped.err, HasSubstr("drape-lab: implicit_midpoint has made"));
    EXPECT_FALSE(folder.has("unstable.toml")) << "no one step shows it";
}

TEST(LabSimulate, EndsWhereDormandPrinceDoesNotComeThrough) {
    const LabFolder folder;
    const LabRun run = folder.run({"simulate", "two_corners", "--time", "0.2", "--set", "integrator=dormand_prince",
                                   "structural.stiffness=4e6", "solver.dt=0.1"});
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, AllOf(HasSubstr("dormand_prince"), HasSubstr("10000 inner steps"), HasSubstr("1e-06")));
}

TEST(LabSimulate, PlaysARecordingAndSaysIfItDiffers) {
    const LabFolder folder;
    const std::string head = "drape-recording 1\nscene drop\nset cloth.mass=0.3\n";
    folder.write("good.txt", head + "100 set wind.on=true\n200 end\n");
    folder.write("differs.txt", head + "100 set wind.on=true\n150 hash 0123456789abcdef\n200 end\n");
    folder.write("cut.txt", head + "100 set wind.on=true\n150 ha");
    const LabRun good = folder.run({"simulate", "--time", "0.05", "--replay", "good.txt", "--hash"});
    EXPECT_EQ(good.code, 0);
    EXPECT_EQ(lines_of(good.err).size(), 1u);
    const LabRun differs = folder.run({"simulate", "--time", "0.05", "--replay", "differs.txt", "--hash"});
    EXPECT_THAT(differs.err, HasSubstr("before step 150"));
    EXPECT_EQ(differs.code, 1);
    EXPECT_EQ(differs.out, good.out);
    const LabRun cut = folder.run({"simulate", "--time", "0.05", "--replay", "cut.txt", "--hash"});
    EXPECT_THAT(cut.err, HasSubstr("cut.txt:5: cut off"));
    EXPECT_EQ(cut.out, good.out);
    EXPECT_NE(folder.run({"simulate", "drop", "--set", "cloth.mass=0.3", "--time", "0.05", "--hash"}).out, good.out);
}

TEST(LabSimulate, PlaysAWholeRecordingWhereNoTimeIsGiven) {
    const LabFolder folder;
    const std::string text = "drape-recording 1\nscene drop\n0 set dt=1e-4\n100 set dt=2e-4\n";
    folder.write("whole.txt", text + "150 end\n");
    folder.write("cut.txt", text);
    const LabRun whole = folder.run({"simulate", "--replay", "whole.txt", "--hash", "--stats", "stats.csv"});
    ASSERT_EQ(whole.code, 0) << whole.err;
    EXPECT_DOUBLE_EQ(values_of(table_of(folder, "stats.csv")[1])[1], 0.02);
    EXPECT_EQ(whole.out, folder.run({"simulate", "--replay", "cut.txt", "--time", "0.02", "--hash"}).out);
}

TEST(LabSimulate, PlaysACutRecordingToItsLastWholeCommandWhereNoTimeIsGiven) {
    const LabFolder folder;
    const std::string text = "drape-recording 1\nscene drop\n0 set dt=1e-4\n100 set dt=2e-4\n";
    folder.write("whole.txt", text + "100 end\n");
    folder.write("cut.txt", text + "9999 ste");
    folder.write("endless.txt", text + "9223372036854775807 end\n");
    const std::string hash = folder.run({"simulate", "--replay", "whole.txt", "--hash"}).out;
    for (const char* file : {"cut.txt", "endless.txt"}) {
        const LabRun cut = folder.run({"simulate", "--replay", file, "--hash"});
        EXPECT_EQ(cut.code, 0) << file;
        EXPECT_EQ(cut.out, hash) << file;
        EXPECT_THAT(cut.err, HasSubstr(std::string(file) + ":5: ")) << file;
        EXPECT_THAT(cut.err, HasSubstr("100 steps to 0.01 s")) << file;
    }
}

TEST(LabSimulate, FailsWhereAReplayRefusesACommand) {
    const LabFolder folder;
    folder.write("refused.txt", "drape-recording 1\nscene drop\n3 grab 0 899\n5 end\n");
    EXPECT_EQ(folder.run({"simulate", "--replay", "refused.txt"}).code, 0);
    const LabRun run = folder.run({"simulate", "--replay", "refused.txt", "--set", "cloth.particles=9,9"});
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("refused.txt:3: 'grab 0 899' is refused: grab: particle 899: allowed 0 to 80"));
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
    folder.write("scene.toml", "start = \"start.csv\"\n" + read_scene("hang"));
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

// Before the first impact: contact multiplies what rounding leaves, a thousandfold within a tenth of a second.
TEST(LabSingle, RunsInSinglePrecision) {
    const LabFolder folder;
    const std::vector<std::string> words{"simulate", "drop", "--time", "0.1", "--hash", "--state", "state.csv"};
    const LabRun twice = folder.run(words);
    const auto exact = lines_of(folder.read("state.csv"));
    const LabRun once = folder.run(words, DRAPE_LAB_SINGLE);
    const auto rounded = lines_of(folder.read("state.csv"));
    EXPECT_EQ(once.code, 0) << once.err;
    EXPECT_THAT(once.out, MatchesRegex("[0-9a-f]+\n"));
    EXPECT_NE(once.out, twice.out);
    ASSERT_EQ(exact.size(), rounded.size());
    for (std::size_t i = 1; i < exact.size(); ++i) EXPECT_NEAR(values_of(exact[i])[3], values_of(rounded[i])[3], 2e-6);
}

// A step length is counted with in double precision, as it was given.
TEST(LabSingle, MakesAsManyStepsAsFit) {
    const LabFolder folder;
    const std::vector<std::array<std::string, 3>> runs{{"0.5", "5e-4", "1000"}, {"1", "1e-3", "1000"},
                                                       {"0.2", "2e-4", "1000"}, {"1", "0.0016666666666666668", "600"},
                                                       {"0.7", "7e-4", "1000"}, {"0.3", "1e-4", "3000"},
                                                       {"0.1", "1e-5", "10000"}};
    for (const auto& [time, dt, steps] : runs) {
        for (const char* program : {DRAPE_LAB, DRAPE_LAB_SINGLE}) {
            const LabRun run = folder.run({"simulate", "two_corners", "--time", time, "--stats", "stats.csv", "--set",
                                           "dt=" + dt, "cloth.particles=2,2", "sleep_speed=0"},
                                          program);
            EXPECT_THAT(run.err, HasSubstr(steps + " steps to " + time + " s")) << dt << " " << program;
            EXPECT_DOUBLE_EQ(values_of(table_of(folder, "stats.csv")[1])[1], parse_real(time).value());
        }
    }
}

TEST(LabHelp, GoesToStandardOutputWithEverySetting) {
    const LabFolder folder;
    const LabRun help = folder.run({"simulate", "--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_THAT(help.out, AllOf(HasSubstr("--state"), HasSubstr("solver.dt"), HasSubstr("contact.leaf_cells")));
    EXPECT_THAT(help.err, IsEmpty());
    const LabRun version = folder.run({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out, std::string("drape-lab ") + DRAPE_VERSION + "\n");
}

}  // namespace
}  // namespace drape
