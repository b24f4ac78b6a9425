#include <gmock/gmock.h>

#include <array>

#include "drape/base/commit.h"
#include "drape/base/numbers.h"
#include "drape/scene/scene.h"
#include "drape/session/session.h"
#include "drape/sim/step_report.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::lines_of;
using test::table_of;
using test::values_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::StartsWith;

TEST(LabSimulate, PrintsTheHashOfTheSameStateAsTheLibraryWithSettingsAnywhere) {
    const LabFolder folder;
    const LabRun run = folder.run({"simulate", "drop", "--time", "0.05", "--hash"});
    Session session(Simulation("drop", load_scene("drop")));
    session.run_until(0.05);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.out, hash_text(session.simulation().hash()) + "\n");
    EXPECT_THAT(run.err, StartsWith(std::to_string(session.simulation().report().step) + " steps to 0.05 s in "));
    const std::vector<std::vector<std::string>> same{
        {"simulate", "--set", "volume=brute", "leaf_cells=2", "--time=0.02,0.05", "--hash", "drop"},
        {"simulate", "drop", "--set", "volume=brute", "--set", "leaf_cells=1", "--time", "0.05", "--hash"}};
    for (const auto& words : same) EXPECT_EQ(folder.run(words).out, run.out);
    EXPECT_NE(folder.run({"simulate", "drop", "--time", "0.05", "--hash", "--set", "cloth.mass=0.3"}).out, run.out);
}

TEST(LabSimulate, WritesEveryParticleAtEveryTimeSoThatItReadsBack) {
    const LabFolder folder;
    ASSERT_EQ(folder.run({"simulate", "drop", "--time", "0,0.05", "--state", "state.csv"}).code, 0);
    const auto lines = lines_of(folder.read("state.csv"));
    ASSERT_EQ(lines.size(), 2u + 2 * 901);
    EXPECT_EQ(lines[0], "t,particle,x,y,z,vx,vy,vz");
    EXPECT_EQ(lines[1], "# t,ball,x,y,z,vx,vy,vz,turn_x,turn_y,turn_z,turn_w,spin_x,spin_y,spin_z");
    EXPECT_THAT(lines[902], StartsWith("# 0,0,"));
    EXPECT_THAT(lines.back(), StartsWith("# "));
    Session session(Simulation("drop", load_scene("drop")));
    session.run_until(0.05);
    const ClothState& state = session.simulation().cloths()[0].state;
    for (int p = 0; p < 900; ++p) {
        const std::vector<double> row = values_of(lines[static_cast<std::size_t>(903 + p)]);
        EXPECT_EQ(row, (std::vector<double>{row[0], static_cast<double>(p), state.x(p, 0), state.x(p, 1), state.x(p, 2),
                                            state.v(p, 0), state.v(p, 1), state.v(p, 2)}));
        EXPECT_DOUBLE_EQ(row[0], 0.05);
    }
    EXPECT_EQ(values_of(lines[2])[0], 0);
}

TEST(LabSimulate, WritesEveryFieldOfTheReportAndOfABallWithItsUnit) {
    const LabFolder folder;
    const std::vector<std::string> words{"simulate", "trampoline", "--time", "0,0.01", "--stats", "stats.csv"};
    ASSERT_EQ(folder.run(words).code, 0);
    EXPECT_EQ(lines_of(folder.read("stats.csv")).size(), 4u);
    const auto lines = table_of(folder, "stats.csv");
    ASSERT_EQ(lines.size(), 3u);
    std::string header;
    for (const ReportField& field : report_fields()) header += (header.empty() ? "" : ",") + std::string(field.name);
    for (const BallField& field : ball_fields()) header += ",ball0_" + std::string(field.name);
    EXPECT_EQ(lines[0], header);
    Session session(Simulation("trampoline", load_scene("trampoline")));
    session.run_until(0.01);
    const std::vector<double> row = values_of(lines[2]);
    ASSERT_EQ(row.size(), report_fields().size() + ball_fields().size());
    EXPECT_EQ(row[0], static_cast<double>(session.simulation().report().step));
    EXPECT_DOUBLE_EQ(row[1], session.simulation().report().time);
    const Ball& ball = session.simulation().balls()[0];
    const std::vector<double> wanted{ball.centre.x(),   ball.centre.y(),   ball.centre.z(),
                                     ball.velocity.x(), ball.velocity.y(), ball.velocity.z(),
                                     ball.spin.x(),     ball.spin.y(),     ball.spin.z()};
    EXPECT_EQ(std::vector<double>(row.end() - 9, row.end()), wanted);
    EXPECT_LT(ball.velocity.y(), 0);
    const std::string units = lines_of(folder.read("stats.csv"))[0];
    EXPECT_THAT(units, StartsWith("# units: time [s], step_limit_ratio [1], residual [1], "));
    EXPECT_THAT(units, HasSubstr(", ball0_vy [m/s], ball0_vz [m/s], ball0_spin_x [rad/s]"));
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
    const auto lines = table_of(folder, "end.csv");
    EXPECT_DOUBLE_EQ(values_of(lines[1])[0], 0.1);
    EXPECT_DOUBLE_EQ(values_of(lines.back())[0], 0.15);
    const LabRun early = run({"--set", "start=start.csv", "--time", "0.05"});
    EXPECT_EQ(early.code, 2);
    EXPECT_THAT(early.err, HasSubstr("--time 0.05: allowed 0.1 <= T <= 1000000.1 s, for the scene starts at t = 0.1"));
}

TEST(LabSimulate, FailsAndSaysWhatMadeTheClothDiverge) {
    const LabFolder folder;
    const LabRun failed = folder.run({"simulate", "drop", "--time", "0,5,6", "--hash", "--state", "state.csv", "--set",
                                      "dt=0.05", "integrator=explicit_euler"});
    EXPECT_EQ(failed.code, 1);
    EXPECT_THAT(failed.err, AllOf(HasSubstr("particle "), HasSubstr("of explicit_euler")));
    EXPECT_EQ(failed.out.size(), 17u) << "the hash of the last good state";
    EXPECT_EQ(table_of(folder, "state.csv").size(), 1u + 900u) << "no rows for times that it did not get to";
    const LabRun stuck = folder.run({"simulate", "two_corners", "--time", "0.2", "--set", "integrator=dormand_prince",
                                     "structural.stiffness=4e6", "solver.dt=0.1"});
    EXPECT_EQ(stuck.code, 1);
    EXPECT_THAT(stuck.err, AllOf(HasSubstr("dormand_prince"), HasSubstr("10000 inner steps"), HasSubstr("1e-06")));
}

TEST(LabSimulate, MarksARunThatItsMethodHasHeatedOrEndsIt) {
    const LabFolder folder;
    const auto run = [&](const std::string& what) {
        return folder.run({"simulate", "two_corners", "--time", "1", "--set", "cloth.particles=16,16", "dt=0.05",
                           "integrator=implicit_midpoint", "on_unstable=" + what});
    };
    const LabRun marked = run("warn"), stopped = run("stop");
    EXPECT_EQ(marked.code, 0);
    EXPECT_THAT(marked.err, HasSubstr("warning: implicit_midpoint has gained"));
    EXPECT_EQ(stopped.code, 1);
    EXPECT_THAT(stopped.err, HasSubstr("drape-lab: implicit_midpoint has gained"));
    EXPECT_FALSE(folder.has("unstable.toml")) << "no one step shows it";
}

TEST(LabSimulate, WarnsOfABallThatMayHaveGoneThrough) {
    const LabFolder folder;
    const LabRun run = folder.run({"simulate", "bullet", "--time", "0.3", "--set", "contact.continuous=false",
                                   "dt=5e-3", "integrator=backward_euler", "ball.velocity=0,-2,0",
                                   "ball.position=0,50,-5", "ground.solid=false"});
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.err, HasSubstr("warning: contact.continuous = false: cloth and a ball"));
}

// Before the first impact: contact multiplies what rounding leaves, a thousandfold within a tenth of a second.
TEST(NightlyLabSingle, RunsInSinglePrecision) {
    const LabFolder folder;
    const std::vector<std::string> words{"simulate", "drop", "--time", "0.1", "--hash", "--state", "state.csv"};
    const LabRun twice = folder.run(words);
    const auto exact = table_of(folder, "state.csv");
    const LabRun once = folder.run(words, DRAPE_LAB_SINGLE);
    const auto rounded = table_of(folder, "state.csv");
    EXPECT_EQ(once.code, 0) << once.err;
    EXPECT_THAT(once.out, MatchesRegex("[0-9a-f]+\n"));
    EXPECT_NE(once.out, twice.out);
    ASSERT_EQ(exact.size(), rounded.size());
    for (std::size_t i = 1; i < exact.size(); ++i) EXPECT_NEAR(values_of(exact[i])[3], values_of(rounded[i])[3], 2e-6);
}

// A step length is counted with in double precision, as it was given.
TEST(NightlyLabSingle, MakesAsManyStepsAsFit) {
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
    EXPECT_THAT(version.out, MatchesRegex(std::string("drape-lab ") + DRAPE_VERSION + ", commit " + commit() +
                                          "\nBuilt from Eigen [0-9.]+, .*freeglut [0-9.]+\n"));
}

}  // namespace
}  // namespace drape
