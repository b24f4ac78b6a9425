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
    const Row run = run_to_rest("drop", settings, 10);
    Simulation simulation("drop", settings);
    while (!simulation.report().asleep && simulation.report().time < 10) simulation.step();
    EXPECT_EQ(run.number("asleep_s"), simulation.report().time);
    EXPECT_LT(run.number("speed_before_m_per_s"), 2e-4);
    EXPECT_LT(run.number("speed_after_m_per_s"), run.number("speed_before_m_per_s"));
    const Row early = run_to_rest("drop", settings, 1);
    EXPECT_EQ(early.word("end"), "awake");
    EXPECT_GT(early.number("speed_after_m_per_s"), 0.01) << "it has not come to rest";
}

TEST(DriftRun, IsHowFarTheFarthestParticleWasFromWhereItRested) {
    Settings settings = rest_settings(quick_case, 9);
    EXPECT_LT(watch_drift("drop", settings, 6, 0.5).number("drift_m"), 1e-4);
    const Row fall = watch_drift("drop", settings, 0, 2.5);
    Simulation simulation("drop", settings);
    const Points start = simulation.cloths()[0].state.x;
    double farthest = 0;
    for (const double time : {1.0, 2.0, 2.5}) {
        while (simulation.report().time < time - 1e-6) simulation.step();
        const Points moved = simulation.cloths()[0].state.x - start;
        farthest = std::max(farthest, static_cast<double>(moved.rowwise().norm().maxCoeff()));
    }
    EXPECT_EQ(fall.number("drift_m"), farthest);
    EXPECT_GT(farthest, 0.1);
    EXPECT_EQ(fall.word("end"), "awake");
    settings.solver.dt = 0.02;
    EXPECT_EQ(watch_drift("drop", settings, 1, 1).word("end"), "diverged");
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
    const std::tuple<const char*, const char*, const char*> cases[]{
        {"2-2", "rest, drop, projection, symplectic_euler, asleep: 1 row, step_s 0.000313, asleep_s ",
         "2,rest,drop,projection,symplectic_euler,0.000313,asleep,"},
        {"22-22", "drift, drop, projection, velocity_verlet, awake: 1 row, step_s 0.000313, ",
         "22,drift,drop,projection,velocity_verlet,0.000313,awake,nan,nan,"}};
    for (const auto& [number, said, row] : cases) {
        const LabRun run = folder.run({"rest", "--quick", "--cases", number, "--out", number});
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr(said));
        const auto rows = table_of(folder, std::string(number) + "/rest.csv");
        ASSERT_EQ(rows.size(), 2u);
        EXPECT_THAT(rows[1], HasSubstr(row));
    }
}

}  // namespace
}  // namespace drape
