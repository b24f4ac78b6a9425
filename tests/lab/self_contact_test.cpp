// The experiment on contact between cloths: its trial, what it finds with the fail-safe and without, and its table.

#include <gmock/gmock.h>

#include "drape/sim/simulation.h"
#include "lab/contact/self_contact_trial.h"
#include "lab/experiments.h"
#include "lab/lab_run.h"
#include "support/crossings.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using ::testing::HasSubstr;

/// So thin and fast that the response alone does not keep them apart.
const ThrownSheet& thin_sheets() {
    static const ThrownSheet scene = throw_sheet(8, Real(1.25e-4));
    return scene;
}

constexpr Real long_step = Real(1) / 240;

TEST(SelfContactTrial, DoesWhatTheSimulationDoesToTheSameBits) {
    ThrownSheet scene = throw_sheet(4, Real(0.004));
    scene.gravity = standard_gravity();
    scene.settings.solver.integrator = IntegratorKind::SymplecticEuler;
    scene.settings.solver.dt = 5e-4;
    Simulation simulation("thrown", scene.settings, StartState{0, scene.start});
    SelfContactTrial trial(scene, static_cast<Real>(scene.settings.solver.dt), true);
    std::int64_t pairs = 0;
    for (int step = 0; step < 120; ++step) {
        simulation.step();
        trial.advance();
        ASSERT_EQ(simulation.report().substeps, 1);
        pairs += simulation.report().pairs;
    }
    EXPECT_GT(pairs, 1000);
    for (const std::size_t sheet : {0u, 1u}) {
        EXPECT_EQ(trial.state(sheet).x, simulation.cloths()[sheet].state.x) << sheet;
        EXPECT_EQ(trial.state(sheet).v, simulation.cloths()[sheet].state.v) << sheet;
    }
}

TEST(ThrownSheets, CrossWithoutTheFailSafeAndNeverWithIt) {
    const SelfContactHistory with = watch_sheets(thin_sheets(), long_step, true);
    const SelfContactHistory without = watch_sheets(thin_sheets(), long_step, false);
    EXPECT_EQ(with.crossed_steps, 0);
    EXPECT_GT(with.held_back, 1);
    EXPECT_LT(with.penetration, 1.25e-4) << "something is left of the thickness";
    EXPECT_GT(without.crossings, 0);
    EXPECT_GT(without.crossed_steps, 0.5);
    EXPECT_EQ(without.held_back, 0);
    EXPECT_EQ(without.penetration, static_cast<double>(Real(1.25e-4)));
    for (const SelfContactHistory& run : {with, without}) {
        EXPECT_EQ(run.unsearched_steps, 0);
        EXPECT_LT(run.momentum_change, 1e-4) << "what one sheet loses, the other gets";
    }
}

TEST(ThrownSheets, PassThroughEachOtherWhereTheSearchGivesUp) {
    const SelfContactHistory run = watch_sheets(thin_sheets(), Real(1) / 60, true);
    EXPECT_GT(run.unsearched_steps, 0);
    EXPECT_GT(run.crossed_steps, 0);
}

TEST(ThrownSheets, PassOnTheMomentumOfTheReferenceTheBetterTheShorterTheStep) {
    const ThrownSheet scene = throw_sheet(8, Real(0.008));
    const SelfContactHistory reference = watch_sheets(scene, Real(1) / 3840, true);
    const double shorter = momentum_error(watch_sheets(scene, Real(1) / 1920, true), reference);
    const double through = momentum_error(watch_sheets(scene, Real(1) / 60, true), reference);
    EXPECT_LT(shorter, 0.2);
    EXPECT_GT(through, 0.9) << "nothing is passed on by a sheet that goes through the other";
    EXPECT_EQ(momentum_error(reference, reference), 0);
}

TEST(SelfContactTrial, CountsTheCrossingsOfExactArithmetic) {
    SelfContactTrial trial(thin_sheets(), long_step, false);
    std::int64_t all = 0;
    for (int step = 0; step < 24; ++step) {
        trial.advance();
        std::array<CellBoxes, 2> boxes;
        const Grid grid = thin_sheets().settings.cloths[0].particles;
        std::vector<BoxedCloth> sheets;
        for (const int s : {0, 1}) {
            const Points& x = trial.state(static_cast<std::size_t>(s)).x;
            boxes[static_cast<std::size_t>(s)].build(grid, x);
            sheets.push_back({{s, grid, x}, boxes[static_cast<std::size_t>(s)]});
        }
        const std::int64_t exact = test::crossings(sheets[0], sheets[0]) + test::crossings(sheets[1], sheets[1]) +
                                   test::crossings(sheets[0], sheets[1]);
        EXPECT_EQ(trial.crossings() > 0, exact > 0) << step;
        all += exact;
    }
    EXPECT_GT(all, 0);
}

TEST(LabSelfContact, WritesARowForEachStepWithTheFailSafeAndWithout) {
    const LabFolder folder;
    const LabRun run = folder.run({"self_contact", "--quick", "--cases", "1-1", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    std::vector<std::string> lines = test::lines_of(folder.read("out/self_contact.csv"));
    std::erase_if(lines, [](const std::string& line) { return line.starts_with('#'); });
    ASSERT_EQ(lines.size(), 9u) << "a header, four steps twice";
    EXPECT_THAT(lines[1], HasSubstr("1,0.000125,0.00833333,on,"));
    EXPECT_THAT(lines[2], HasSubstr("1,0.000125,0.00833333,off,"));
    EXPECT_THAT(run.out, HasSubstr("0.125 mm, step 1/240 s, fail-safe on: crossings after 0 % of the steps"));
}

}  // namespace
}  // namespace drape
