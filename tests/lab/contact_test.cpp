// The experiment on the accuracy of contact: its parts, and what its cases find.

#include <gtest/gtest.h>

#include "drape/bounds/node_view.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "lab/contact/contact_trial.h"
#include "lab/experiments.h"

namespace drape {
namespace {

TEST(ContactTrial, DoesWhatTheSimulationDoesToTheSameBits) {
    for (const char* setting : {"contact.continuous=false", "contact.search_tests=20", "contact.continuous=true",
                                "solver.integrator=velocity_verlet", "solver.integrator=implicit_midpoint",
                                "solver.integrator=backward_euler"}) {
        Settings settings = load_scene("drop");
        assign(settings, "contact.continuous=false");
        assign(settings, setting);
        ContactTrial trial(settings);
        Simulation simulation("drop", settings);
        std::int64_t contacts = 0;
        for (int step = 0; step < 900; ++step) {
            simulation.step();
            trial.advance(static_cast<Real>(settings.solver.dt));
            trial.respond();
            contacts += simulation.report().contacts;
        }
        EXPECT_GT(contacts, 100) << setting;
        EXPECT_EQ(trial.cloths[0].state.x, simulation.cloths()[0].state.x) << setting;
    }
}

TEST(LongHungCloth, IsEnteredDeeperTheLongerTheStepAndPassedWhereALimitedSearchPushesTooSlowly) {
    const ExperimentCases cases = contact_experiment().cases(true);
    const Rows longer = cases[7](), shorter = cases[9]();  // 8 m/s, steps of 1/60 and 1/240 s
    for (const std::size_t search : {0u, 1u}) {
        EXPECT_GT(longer[search].number("penetration_m"), shorter[search].number("penetration_m"));
        EXPECT_GT(longer[search].number("left_m"), shorter[search].number("left_m"));
        EXPECT_GT(longer[search].number("momentum_error"), shorter[search].number("momentum_error"));
        EXPECT_EQ(longer[search].word("passed"), "0");
    }
    EXPECT_LT(shorter[0].number("reference_penetration_m"), 2e-4);
    EXPECT_LT(shorter[0].number("missed_contacts"), 0.2);
    EXPECT_GT(longer[0].number("missed_contacts"), 0.2);
    EXPECT_LT(longer[1].number("missed_contacts"), 0.1);
    EXPECT_EQ(longer[3].word("passed"), "1");
    EXPECT_GT(longer[3].number("false_contacts"), 0.1);
}

TEST(HungCloth, IsHeldByAContinuousSearchAtTheStepsAtWhichADiscreteOneIsPassed) {
    const Rows rows = contact_experiment().cases(true)[12]();  // in a step the ball goes more than a metre
    const Row &discrete = rows[0], &continuous = rows[1];
    EXPECT_EQ(discrete.word("passed"), "1");
    EXPECT_EQ(continuous.word("passed"), "0");
    EXPECT_EQ(discrete.number("missed_contacts"), 1);
    EXPECT_EQ(continuous.number("missed_steps"), 0);
    EXPECT_LT(continuous.number("missed_contacts"), 0.1);
    EXPECT_LT(continuous.number("momentum_error"), discrete.number("momentum_error"));
}

}  // namespace
}  // namespace drape
