// The experiment on the accuracy of contact: its parts, and a share of it run as a program.

#include <gmock/gmock.h>

#include "drape/bounds/node_view.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "lab/contact/contact_trial.h"
#include "lab/experiments.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using ::testing::HasSubstr;

TEST(ContactTrial, DoesWhatTheSimulationDoesToTheSameBits) {
    for (const char* setting : {"contact.continuous=false", "contact.search_tests=20", "contact.continuous=true",
                                "solver.integrator=velocity_verlet", "solver.integrator=implicit_midpoint",
                                "solver.integrator=backward_euler"}) {
        Settings settings = load_scene("drop");
        assign(settings, "contact.continuous=false");
        assign(settings, setting);
        ContactTrial trial(ContactScene{.settings = settings}, settings.solver.dt);
        Simulation simulation("drop", settings);
        std::int64_t contacts = 0;
        for (int step = 0; step < 900; ++step) {
            simulation.step();
            trial.advance();
            trial.respond();
            contacts += simulation.report().contacts;
        }
        EXPECT_GT(contacts, 100) << setting;
        EXPECT_EQ(trial.state().x, simulation.cloths()[0].state.x) << setting;
    }
}

TEST(CompareContacts, CountsWhatTheReferenceTouchedAndTheRunDidNot) {
    // Three steps of the run, two of the reference in each
    const ContactHistory reference{.touched = {{}, {}, {1, 2}, {2, 3}, {4}, {}}};
    const auto errors = [&reference](std::vector<std::vector<int>> touched, bool passed = false) {
        return compare_contacts({.touched = std::move(touched), .passed = passed}, reference, 2);
    };
    EXPECT_EQ(errors({{}, {1, 2, 3}, {4}}).number("missed_contacts"), 0);
    EXPECT_EQ(errors({{7}, {1, 2, 3, 8}, {4, 9}}).number("missed_contacts"), 0) << "more is not missed";
    EXPECT_EQ(errors({{}, {1, 3}, {4}}).number("missed_contacts"), 0.25);
    EXPECT_EQ(errors({{}, {1, 3}, {4}}).number("missed_steps"), 0);
    EXPECT_EQ(errors({{4}, {1, 2, 3}, {}}).number("missed_contacts"), 0.25) << "at the right time only";
    EXPECT_EQ(errors({{4}, {1, 2, 3}, {}}).number("missed_steps"), 0.5);
    EXPECT_EQ(errors({{}, {}, {}}).number("missed_contacts"), 1);
    EXPECT_EQ(errors({{}, {}, {}}).number("missed_steps"), 1);
    EXPECT_EQ(errors({{}, {}, {}}, true).word("passed"), "1");
    EXPECT_EQ(
        compare_contacts({.touched = {{1}}, .passed = true}, {.touched = {{1}}, .passed = true}, 1).word("passed"),
        "0");
}

TEST(HungCloth, IsEnteredDeeperTheLongerTheStepAndPassedWhereALimitedSearchPushesTooSlowly) {
    constexpr double speed = 8;  // m/s
    const ContactScene scene = hung_cloth_and_ball(speed, 0.004);
    const ContactHistory reference = watch_contacts(scene, Real(0.0005));
    EXPECT_FALSE(reference.passed);
    EXPECT_LT(reference.left, 2e-4);
    EXPECT_LT(reference.entered, 1.5 * speed * 0.0005 + 1e-3) << "about as deep as the ball goes in a step";
    double before = reference.entered;
    for (const int finer : {2, 8}) {
        const ContactHistory run = watch_contacts(scene, static_cast<Real>(0.0005 * finer));
        EXPECT_GT(run.entered, before) << finer;
        EXPECT_LT(compare_contacts(run, reference, finer).number("missed_contacts"), 0.2) << finer;
        before = run.entered;
    }
    const ContactHistory limited = watch_contacts(scene.with({"contact.search_tests=1"}), Real(0.004));
    EXPECT_GT(limited.left, 0.1);
    EXPECT_GT(limited.false_contacts, 0.1);
}

TEST(HungCloth, IsHeldByAContinuousSearchAtTheStepsAtWhichADiscreteOneIsPassed) {
    // In a step the ball goes more than a metre
    const ContactScene scene = hung_cloth_and_ball(32, Real(1) / 30);
    const ContactHistory truth =
        watch_contacts(scene.with({"contact.volume=brute", "contact.continuous=auto"}), Real(1) / 3000);
    const ContactHistory discrete = watch_contacts(scene, Real(1) / 30);
    const ContactHistory continuous = watch_contacts(scene.with({"contact.continuous=auto"}), Real(1) / 30);
    EXPECT_FALSE(truth.passed);
    EXPECT_TRUE(discrete.passed);
    EXPECT_FALSE(continuous.passed);
    const Row missed = compare_contacts(discrete, truth, 100);
    const Row found = compare_contacts(continuous, truth, 100);
    EXPECT_EQ(missed.number("missed_contacts"), 1);
    EXPECT_EQ(found.number("missed_steps"), 0);
    EXPECT_LT(found.number("missed_contacts"), 0.1);
    EXPECT_LT(found.number("momentum_error"), missed.number("momentum_error"));
}

TEST(LabContact, WritesARowASearch) {
    const LabFolder folder;
    // The shortest of its runs: a fast ball at long steps
    const std::string all = std::to_string(contact_experiment().cases(true).size());
    const LabRun run = folder.run({"contact", "--quick", "--share", "14/" + all, "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("discrete, tests 0, speed_m_per_s 32, passed "));
    const auto rows = table_of(folder, "out/contact.csv");
    ASSERT_EQ(rows.size(), 5u) << "a header and four searches";
    EXPECT_THAT(rows[1], HasSubstr("discrete,0,32,"));
}

}  // namespace
}  // namespace drape
