#include <gmock/gmock.h>

#include "drape/base/numbers.h"
#include "drape/sim/scene.h"
#include "drape/sim/session.h"
#include "drape/sim/step_report.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::StartsWith;
using testing_aid::LabFolder;
using testing_aid::LabRun;
using testing_aid::lines_of;

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
    const auto lines = lines_of(folder.read("stats.csv"));
    ASSERT_EQ(lines.size(), 3u);
    std::string header;
    for (const ReportField& field : report_fields()) header += (header.empty() ? "" : ",") + std::string(field.name);
    EXPECT_EQ(lines[0], header);
    EXPECT_EQ(values_of(lines[2]).size(), report_fields().size());
    EXPECT_NEAR(values_of(lines[2])[0], 0.02 / static_cast<double>(load_scene("curtain").solver.dt), 1e-6);
    EXPECT_DOUBLE_EQ(values_of(lines[2])[1], 0.02);
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
    EXPECT_DOUBLE_EQ(values_of(lines_of(folder.read("stats.csv"))[1])[1], 0.02);
    EXPECT_EQ(whole.out, folder.run({"simulate", "--replay", "cut.txt", "--time", "0.02", "--hash"}).out);
    EXPECT_EQ(folder.run({"simulate", "--replay", "cut.txt", "--hash"}).code, 2) << "nobody knows when it ended";
}

TEST(LabSimulate, RefusesOneFileForStateAndStats) {
    const LabFolder folder;
    const LabRun run = folder.run({"simulate", "drop", "--time", "0", "--state", "a.csv", "--stats", "./a.csv"});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("--state and --stats a.csv"));
    EXPECT_EQ(folder.run({"simulate", "drop", "--time", "0", "--state", "/dev/null", "--stats", "/dev/null"}).code, 0);
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
