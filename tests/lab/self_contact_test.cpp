// The experiment on contact between cloths: its trial, and what it finds with the fail-safe and without.

#include <gtest/gtest.h>

#include "drape/sim/simulation.h"
#include "lab/contact/contact_trial.h"
#include "lab/experiments.h"

namespace drape {
namespace {

TEST(ContactTrialOfSheets, DoesWhatTheSimulationDoesToTheSameBits) {
    ContactScene scene = throw_sheet(4, Real(0.004));
    scene.settings.world.gravity = WorldSettings{}.gravity;
    scene.settings.solver.integrator = IntegratorKind::SymplecticEuler;
    scene.settings.solver.dt = 5e-4;
    Simulation simulation("thrown", scene.settings, scene.start);
    ContactTrial trial(scene.settings, scene.start);
    std::int64_t pairs = 0;
    for (int step = 0; step < 120; ++step) {
        simulation.step();
        const SelfContactCounts done = make_step(trial, FailSafe::Zones, static_cast<Real>(scene.settings.solver.dt));
        const StepReport& report = simulation.report();
        ASSERT_EQ(report.substeps, 1);
        ASSERT_EQ(done.at("pair_tests"), report.between_cloths.volume_tests + report.listed_pairs) << step;
        ASSERT_EQ(done.at("held_back"), report.failsafe_particles) << step;
        pairs += report.pairs;
    }
    EXPECT_GT(pairs, 1000);
    for (const std::size_t sheet : {0u, 1u}) {
        EXPECT_EQ(trial.cloths[sheet].state.x, simulation.cloths()[sheet].state.x) << sheet;
        EXPECT_EQ(trial.cloths[sheet].state.v, simulation.cloths()[sheet].state.v) << sheet;
    }
}

TEST(NightlyLabSelfContact, FindsCrossingsWithoutTheFailSafeAndWithItWhereTheSearchGivesUp) {
    const Rows rows = self_contact_experiment().cases(true)[0]();
    ASSERT_EQ(rows.size(), 12u) << "four steps three times";
    const Row &zones = rows[3], &rejection = rows[4], &none = rows[5];  // steps of 1/240 s
    EXPECT_EQ(zones.word("fail_safe"), "zones");
    EXPECT_GT(zones.number("held_back"), 1);
    EXPECT_LT(zones.number("penetration_m"), 1.25e-4) << "something is left of the thickness";
    EXPECT_EQ(rejection.word("fail_safe"), "rejection");
    EXPECT_GT(rejection.number("rejected"), 1);
    EXPECT_EQ(rejection.number("unsafe_steps"), 0);
    EXPECT_EQ(none.word("fail_safe"), "none");
    EXPECT_GT(none.number("crossings"), 0);
    EXPECT_GT(none.number("crossed_steps"), 0.5);
    EXPECT_EQ(none.number("penetration_m"), 1.25e-4);
    for (const Row& row : {zones, rejection}) EXPECT_EQ(row.number("crossed_steps"), 0);
    for (const Row& row : {rejection, none}) EXPECT_EQ(row.number("held_back"), 0);
    for (const Row& row : {zones, rejection, none}) {
        EXPECT_EQ(row.number("unsearched_steps"), 0);
        EXPECT_LT(row.number("momentum_change"), 1e-4) << "what one sheet loses, the other gets";
    }
    // A step that is too long has too many pairs; its halves are searched
    EXPECT_GT(rows[0].number("unsearched_steps"), 0);
    EXPECT_GT(rows[0].number("crossed_steps"), 0);
    EXPECT_EQ(rows[1].number("unsearched_steps"), 0);
    EXPECT_EQ(rows[1].number("crossed_steps"), 0);
    EXPECT_GT(rows[0].number("momentum_error"), rows[1].number("momentum_error"));
}

}  // namespace
}  // namespace drape
