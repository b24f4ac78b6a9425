// The experiment on contact between cloths: its trial, what it finds with the fail-safe and without, and its table.

#include <gmock/gmock.h>

#include "drape/sim/simulation.h"
#include "lab/contact/self_contact_trial.h"
#include "lab/experiments.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using ::testing::HasSubstr;

/// So thin and fast that the response alone does not keep them apart.
const ContactScene& thin_sheets() {
    static const ContactScene scene = throw_sheet(8, Real(1.25e-4));
    return scene;
}

constexpr Real long_step = Real(1) / 240;

TEST(SelfContactTrial, DoesWhatTheSimulationDoesToTheSameBits) {
    ContactScene scene = throw_sheet(4, Real(0.004));
    scene.settings.world.gravity = WorldSettings{}.gravity;
    scene.settings.solver.integrator = IntegratorKind::SymplecticEuler;
    scene.settings.solver.dt = 5e-4;
    Simulation simulation("thrown", scene.settings, StartState{0, scene.start});
    SelfContactTrial trial(scene, static_cast<Real>(scene.settings.solver.dt), FailSafe::Zones);
    std::int64_t pairs = 0;
    for (int step = 0; step < 120; ++step) {
        simulation.step();
        const SelfContactStep done = trial.step();
        const StepReport& report = simulation.report();
        ASSERT_EQ(report.substeps, 1);
        ASSERT_EQ(done.pair_tests, report.between_cloths.volume_tests + report.listed_pairs) << step;
        ASSERT_EQ(done.held_back, report.failsafe_particles) << step;
        pairs += report.pairs;
    }
    EXPECT_GT(pairs, 1000);
    for (const std::size_t sheet : {0u, 1u}) {
        EXPECT_EQ(trial.state(sheet).x, simulation.cloths()[sheet].state.x) << sheet;
        EXPECT_EQ(trial.state(sheet).v, simulation.cloths()[sheet].state.v) << sheet;
    }
}

TEST(LongContactScenes, CrossWithoutTheFailSafeAndNeverWithIt) {
    const SelfContactHistory with = watch_sheets(thin_sheets(), long_step, FailSafe::Zones);
    const SelfContactHistory without = watch_sheets(thin_sheets(), long_step, FailSafe::None);
    const SelfContactHistory rejected = watch_sheets(thin_sheets(), long_step, FailSafe::Rejection);
    EXPECT_GT(with.held_back, 1);
    EXPECT_LT(with.penetration, 1.25e-4) << "something is left of the thickness";
    EXPECT_GT(without.crossings, 0);
    EXPECT_GT(without.crossed_steps, 0.5);
    EXPECT_EQ(without.penetration, static_cast<double>(Real(1.25e-4)));
    EXPECT_GT(rejected.rejected, 1);
    EXPECT_EQ(rejected.unsafe_steps, 0);
    for (const SelfContactHistory& run : {with, rejected}) EXPECT_EQ(run.crossed_steps, 0);
    for (const SelfContactHistory& run : {without, rejected}) EXPECT_EQ(run.held_back, 0);
    for (const SelfContactHistory& run : {with, without, rejected}) {
        EXPECT_EQ(run.unsearched_steps, 0);
        EXPECT_LT(run.momentum_change, 1e-4) << "what one sheet loses, the other gets";
    }
}

TEST(NightlyThrownSheets, AreSearchedInHalvesOfAStepThatIsTooLongAndPassWhereTheSearchGivesUp) {
    const SelfContactHistory halved = watch_sheets(thin_sheets(), Real(1) / 120, FailSafe::Rejection);
    EXPECT_EQ(halved.unsearched_steps, 0);
    EXPECT_EQ(halved.crossed_steps, 0);
    const SelfContactHistory given_up = watch_sheets(thin_sheets(), Real(1) / 60, FailSafe::Zones);
    EXPECT_GT(given_up.unsearched_steps, 0);
    EXPECT_GT(given_up.crossed_steps, 0);
}

TEST(NightlyThrownSheets, PassOnTheMomentumOfTheReferenceTheBetterTheShorterTheStep) {
    const ContactScene scene = throw_sheet(8, Real(0.008));
    const SelfContactHistory reference = watch_sheets(scene, Real(1) / 3840, FailSafe::Zones);
    const double shorter = momentum_error(watch_sheets(scene, Real(1) / 1920, FailSafe::Zones), reference);
    const double through = momentum_error(watch_sheets(scene, Real(1) / 60, FailSafe::Zones), reference);
    EXPECT_LT(shorter, 0.2);
    EXPECT_GT(through, 0.9) << "nothing is passed on by a sheet that goes through the other";
    SelfContactHistory one, other;
    one.given = Vec3(1, 4, 0), other.given = Vec3(1, 0, -3);
    EXPECT_DOUBLE_EQ(momentum_error(one, other), static_cast<double>(5 / std::sqrt(Real(10))));
}

TEST(NightlyLabSelfContact, WritesARowForEachStepAndFailSafe) {
    const LabFolder folder;
    const LabRun run = folder.run({"self_contact", "--quick", "--cases", "1-1", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const std::vector<std::string> lines = test::table_of(folder, "out/self_contact.csv");
    ASSERT_EQ(lines.size(), 13u) << "a header, four steps three times";
    EXPECT_THAT(lines[1], HasSubstr("1,0.000125,0.00833333,zones,"));
    EXPECT_THAT(lines[2], HasSubstr("1,0.000125,0.00833333,rejection,"));
    EXPECT_THAT(lines[3], HasSubstr("1,0.000125,0.00833333,none,"));
    const auto crossed_steps = [&](std::size_t line, const std::string& fail_safe) {
        return test::values_of(test::replaced(lines[line], "," + fail_safe + ",", ",0,"))[5];
    };
    EXPECT_EQ(crossed_steps(4, "zones"), 0);
    EXPECT_EQ(crossed_steps(5, "rejection"), 0);
    EXPECT_GT(crossed_steps(6, "none"), 0.5);
    EXPECT_THAT(run.out, HasSubstr("thickness_m 0.000125, step_s 0.00416667, zones: 1 row, crossed_steps 0, "));
}

}  // namespace
}  // namespace drape
