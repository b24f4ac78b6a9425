#include <gmock/gmock.h>

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
    EXPECT_THAT(run.out, HasSubstr("1 of 1 are below 0.1 mm/s RMS when they fall asleep"));
    const auto rows = table_of(folder, "out/rest.csv");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_THAT(rows[1], HasSubstr("2,drop,projection,symplectic_euler,0.000313,asleep,"));
}

}  // namespace
}  // namespace drape
