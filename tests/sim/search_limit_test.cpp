// Searches that end early and take nodes for what they hold.

#include <gtest/gtest.h>

#include "sim/small_scene.h"

namespace drape {
namespace {

/// The response leaves so much in place [m].
constexpr double slop = 5e-4;

/// How wrong the drop scene becomes under a limit.
struct Error {
    Real distance = 0;  ///< RMS, of the particles from where the full search has them [m]
    double missed_penetration = 0;
    std::int64_t false_contacts = 0;
    std::int64_t most_tests = 0;
    Status status = Status::Ok;
};

Error error_of_drop(const std::string& limit) {
    constexpr int steps = 2500;
    static const Points exact = [] {
        Simulation simulation = shipped_simulation("drop", {"leaf_cells=4"});  // levels 0 to 3, 85 nodes
        make_steps(simulation, steps);
        return simulation.cloths()[0].state.x;
    }();
    Simulation simulation = shipped_simulation("drop", {"leaf_cells=4", limit});
    Error error;
    for (int step = 0; step < steps; ++step) {
        simulation.step();
        const StepReport& report = simulation.report();
        error.missed_penetration = std::max(error.missed_penetration, report.missed_penetration);
        error.false_contacts += report.false_contacts;
        error.most_tests = std::max(error.most_tests, report.traversal.volume_tests);
    }
    const Points& x = simulation.cloths()[0].state.x;
    EXPECT_TRUE(x.allFinite());
    error.distance = std::sqrt((x - exact).squaredNorm() / static_cast<Real>(x.rows()));
    error.status = simulation.report().status;
    return error;
}

TEST(LimitedSearch, OfAllLevelsAndAnyNumberOfTestsIsTheFullOne) {
    for (const char* limit : {"search_level=29", "search_tests=1000000000"}) {
        Simulation full = small_simulation(), limited = small_simulation({limit});
        make_steps(full, 800), make_steps(limited, 800);
        EXPECT_EQ(full.hash(), limited.hash()) << limit;
        EXPECT_EQ(limited.report().false_contacts, 0);
        EXPECT_GT(limited.report().contacts, 0);
        EXPECT_NEAR(limited.report().missed_penetration, limited.report().penetration, 1e-6) << "the audit agrees";
        EXPECT_EQ(full.report().missed_penetration, 0) << "no audit";
    }
}

TEST(LongLimitedSearch, LetsLessThroughTheDeeperItGoes) {
    Error before{.distance = 1e9, .missed_penetration = 1e9};
    for (int level = 0; level <= 3; ++level) {
        SCOPED_TRACE(level);
        const Error error = error_of_drop("search_level=" + std::to_string(level));
        EXPECT_EQ(error.status, Status::Ok);
        EXPECT_LT(error.missed_penetration, before.missed_penetration + slop);
        EXPECT_TRUE(level < 2 || error.distance < before.distance) << "the cloth is less far off";
        EXPECT_TRUE(level > 0 || error.missed_penetration > 0.1) << "the root's one contact cannot hold the cloth";
        EXPECT_EQ(error.false_contacts > 0, level < 3);
        before = error;
    }
    EXPECT_EQ(before.distance, 0) << "level 3 are the leaves";
}

TEST(LongLimitedSearch, NeverExceedsItsBudgetAndIsBetterTheLargerThatIs) {
    Error before{.distance = 1e9, .missed_penetration = 1e9};
    for (const int tests : {1, 5, 16, 40, 85}) {
        SCOPED_TRACE(tests);
        const Error error = error_of_drop("search_tests=" + std::to_string(tests));
        EXPECT_EQ(error.status, Status::Ok);
        EXPECT_LE(error.most_tests, tests);
        EXPECT_LT(error.missed_penetration, before.missed_penetration + slop);
        EXPECT_LT(error.distance, before.distance);
        before = error;
    }
    EXPECT_EQ(before.distance, 0) << "85 nodes are all there are";
}

}  // namespace
}  // namespace drape
