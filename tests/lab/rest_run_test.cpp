#include <gmock/gmock.h>

#include <algorithm>

#include "drape/sim/simulation.h"
#include "lab/lab_run.h"
#include "lab/rest/rest_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using testing::HasSubstr;

const RestCase quick_case{"drop", IntegratorKind::SymplecticEuler, ResponseKind::Projection};

TEST(RestRun, FallsAsleepWhenTheSceneDoes) {
    const Settings settings = rest_settings(quick_case, 9);
    const RestRun run = run_to_rest("drop", settings, 10);
    Simulation simulation("drop", settings);
    while (!simulation.report().asleep && simulation.report().time < 10) simulation.step();
    EXPECT_EQ(run.asleep, simulation.report().time);
    EXPECT_LT(run.speed_before, 2e-4);
    EXPECT_LT(run.speed_after, run.speed_before);
}

TEST(RestRun, SaysHowFastAClothIsThatDoesNotComeToRest) {
    const RestRun run = run_to_rest("drop", rest_settings(quick_case, 9), 1);
    EXPECT_EQ(run.asleep, -1);
    EXPECT_GT(run.speed_after, 0.01);
}

TEST(DriftRun, IsHowFarTheFarthestParticleWasFromWhereItRested) {
    const Settings settings = rest_settings(quick_case, 9);
    EXPECT_LT(watch_drift("drop", settings, 6, 0.5).drift, 1e-4);
    const DriftRun fall = watch_drift("drop", settings, 0, 2.5);
    Simulation simulation("drop", settings);
    const Points start = simulation.cloths()[0].state.x;
    double farthest = 0;
    for (const double time : {1.0, 2.0, 2.5}) {
        while (simulation.report().time < time - 1e-6) simulation.step();
        const Points moved = simulation.cloths()[0].state.x - start;
        farthest = std::max(farthest, static_cast<double>(moved.rowwise().norm().maxCoeff()));
    }
    EXPECT_EQ(fall.drift, farthest);
    EXPECT_GT(farthest, 0.1);
    EXPECT_FALSE(fall.diverged);
}

TEST(DriftRun, SaysThatAClothHasDiverged) {
    Settings settings = rest_settings(quick_case, 9);
    settings.solver.dt = 0.02;
    EXPECT_TRUE(watch_drift("drop", settings, 1, 1).diverged);
}

TEST(RestSettings, HaveAStepThatIsStable) {
    EXPECT_EQ(rest_settings(quick_case, 9).solver.dt, 3.125e-4);
    EXPECT_EQ(rest_settings({"drop", IntegratorKind::Xpbd, ResponseKind::Projection}, 0).solver.dt, 1.0 / 60);
    const double penalised = rest_settings({"drop", IntegratorKind::Xpbd, ResponseKind::Penalty}, 0).solver.dt;
    EXPECT_LT(penalised, 5e-4);
    EXPECT_GT(penalised, 0);
}

TEST(LabRest, WritesARowACase) {
    const LabFolder folder;
    const LabRun run = folder.run({"rest", "--quick", "--cases", "2-2", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("1 of 1 are below 0.3 mm/s RMS when they fall asleep"));
    const auto rows = table_of(folder, "out/rest.csv");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_THAT(rows[1], HasSubstr("2,rest,drop,projection,symplectic_euler,0.000313,asleep,"));
}

TEST(LabRest, WritesHowFarAClothHasCrept) {
    const LabFolder folder;
    const LabRun run = folder.run({"rest", "--quick", "--cases", "22-22", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("velocity_verlet, step 0.313 ms: has crept by "));
    const auto rows = table_of(folder, "out/rest.csv");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_THAT(rows[1], HasSubstr("22,drift,drop,projection,velocity_verlet,0.000313,awake,nan,nan,"));
}

}  // namespace
}  // namespace drape
