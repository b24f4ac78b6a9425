// The experiment on the accuracy of contact: its parts, and a share of it run as a program.

#include <gmock/gmock.h>

#include "drape/bounds/node_view.h"
#include "drape/sim/scene.h"
#include "drape/sim/setting_table.h"
#include "drape/sim/simulation.h"
#include "lab/contact/contact_trial.h"
#include "lab/experiments.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::lines_of;
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
        EXPECT_EQ(trial.positions(), simulation.cloths()[0].state.x) << setting;
    }
}

TEST(CompareContacts, CountsWhatTheReferenceTouchedAndTheRunDidNot) {
    // Three steps of the run, two of the reference in each
    const ContactHistory reference{.touched = {{}, {}, {1, 2}, {2, 3}, {4}, {}}};
    const auto errors = [&reference](std::vector<std::vector<int>> touched, bool passed = false) {
        return compare_contacts({.touched = std::move(touched), .passed = passed}, reference, 2);
    };
    EXPECT_EQ(errors({{}, {1, 2, 3}, {4}}).missed_contacts, 0);
    EXPECT_EQ(errors({{7}, {1, 2, 3, 8}, {4, 9}}).missed_contacts, 0) << "more is not missed";
    EXPECT_EQ(errors({{}, {1, 3}, {4}}).missed_contacts, 0.25);
    EXPECT_EQ(errors({{}, {1, 3}, {4}}).missed_steps, 0);
    EXPECT_EQ(errors({{4}, {1, 2, 3}, {}}).missed_contacts, 0.25) << "at the right time only";
    EXPECT_EQ(errors({{4}, {1, 2, 3}, {}}).missed_steps, 0.5);
    EXPECT_EQ(errors({{}, {}, {}}).missed_contacts, 1);
    EXPECT_EQ(errors({{}, {}, {}}).missed_steps, 1);
    EXPECT_TRUE(errors({{}, {}, {}}, true).passed);
    EXPECT_FALSE(compare_contacts({.touched = {{1}}, .passed = true}, {.touched = {{1}}, .passed = true}, 1).passed);
}

class HungCloth : public ::testing::Test {
protected:
    static constexpr double speed_ = 8;  // m/s
    ContactScene scene_ = hung_cloth_and_ball(speed_, 0.004).with({.leaf_cells = 4});
    ContactHistory reference_ = watch_contacts(scene_, Real(0.0005));

    [[nodiscard]] ContactErrors errors_of(const ContactHistory& run, int finer) const {
        return compare_contacts(run, reference_, finer);
    }
};

TEST_F(HungCloth, IsNotPassedByTheBallAtASmallStep) {
    EXPECT_FALSE(reference_.passed);
    EXPECT_LT(reference_.left, 2e-4);
    EXPECT_LT(reference_.entered, 1.5 * speed_ * 0.0005 + 1e-3) << "about as deep as the ball goes in a step";
    const ContactErrors none = errors_of(reference_, 1);
    EXPECT_EQ(none.missed_contacts, 0);
    EXPECT_EQ(none.missed_steps, 0);
    EXPECT_FALSE(none.passed);
}

TEST_F(HungCloth, IsEnteredDeeperTheLongerTheStep) {
    double before = reference_.entered;
    for (const int finer : {2, 8}) {
        const ContactHistory run = watch_contacts(scene_, static_cast<Real>(0.0005 * finer));
        EXPECT_GT(run.entered, before) << finer;
        EXPECT_LT(errors_of(run, finer).missed_contacts, 0.2) << finer;
        before = run.entered;
    }
}

TEST_F(HungCloth, IsHeldByAContinuousSearchAtTheStepsAtWhichADiscreteOneIsPassed) {
    // In a step the ball goes more than a metre
    const ContactScene scene = hung_cloth_and_ball(32, Real(1) / 30);
    const Detection oracle{.volume = VolumeKind::Brute, .continuous = true};
    const ContactHistory truth = watch_contacts(scene.with(oracle), Real(1) / 3000);
    const ContactHistory discrete = watch_contacts(scene.with({.leaf_cells = 4}), Real(1) / 30);
    const ContactHistory continuous = watch_contacts(scene.with({.leaf_cells = 4, .continuous = true}), Real(1) / 30);
    EXPECT_FALSE(truth.passed);
    EXPECT_TRUE(discrete.passed);
    EXPECT_FALSE(continuous.passed);
    const ContactErrors missed = compare_contacts(discrete, truth, 100);
    const ContactErrors found = compare_contacts(continuous, truth, 100);
    EXPECT_EQ(missed.missed_contacts, 1);
    EXPECT_EQ(found.missed_steps, 0);
    EXPECT_LT(found.missed_contacts, 0.1);
    EXPECT_LT(found.momentum, missed.momentum);
}

TEST_F(HungCloth, IsPassedWhereALimitedSearchPushesTooSlowly) {
    const ContactHistory run = watch_contacts(scene_.with({.leaf_cells = 4, .tests = 1}), Real(0.004));
    EXPECT_GT(run.left, 0.1);
    EXPECT_LT(reference_.left, 2e-4);
    EXPECT_GT(run.false_contacts, 0.1);
}

TEST(LabContact, WritesARowASearchAndTheSameErrorsInEveryRun) {
    const LabFolder folder;
    const std::string all = std::to_string(contact_experiment().cases(true).size());
    std::vector<std::vector<std::string>> runs;
    for (const char* out : {"a", "b"}) {
        // The shortest of its runs: a fast ball at long steps
        const LabRun run = folder.run({"contact", "--quick", "--share", "14/" + all, "--out", out});
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr("discrete, ball at 32 m/s: "));
        std::vector<std::string> lines = lines_of(folder.read(std::string(out) + "/contact.csv"));
        std::erase_if(lines, [](const std::string& line) { return line.starts_with('#'); });
        ASSERT_EQ(lines.size(), 5u) << "a header and four searches";
        runs.push_back(lines);
    }
    EXPECT_EQ(runs[0][0], runs[1][0]);
    // All that stands before the times
    const auto errors = [](const std::string& line) {
        std::size_t end = 0;
        for (int k = 0; k < 11; ++k) end = line.find(',', end + 1);
        return line.substr(0, end);
    };
    for (std::size_t k = 1; k < 5; ++k) EXPECT_EQ(errors(runs[0][k]), errors(runs[1][k]));
    EXPECT_THAT(runs[0][1], HasSubstr("discrete,0,32,")) << runs[0][1];
}

}  // namespace
}  // namespace drape
