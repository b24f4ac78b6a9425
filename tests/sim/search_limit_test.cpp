// Searches that end early and take nodes for what they hold.

#include <gtest/gtest.h>

#include "drape/contact/search_audit.h"
#include "drape/sim/scene.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

Simulation drop_with(const std::vector<std::string>& assignments) {
    Settings settings = load_scene("drop");
    settings.contact.leaf_cells = 4;  // levels 0 to 3, 85 nodes
    for (const std::string& assignment : assignments) assign(settings, assignment);
    return {"drop", std::move(settings)};
}

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
        Simulation simulation = drop_with({});
        make_steps(simulation, steps);
        return simulation.cloths()[0].state.x;
    }();
    Simulation simulation = drop_with({limit});
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
        const Error error = error_of_drop("search_level=" + std::to_string(level));
        EXPECT_EQ(error.status, Status::Ok) << level;
        EXPECT_LT(error.missed_penetration, before.missed_penetration + slop) << level;
        if (level >= 2) {
            EXPECT_LT(error.distance, before.distance) << "the cloth stands less far off at level " << level;
        }
        before = error;
        if (level == 0) {
            EXPECT_GT(error.missed_penetration, 0.1) << "the root's one contact cannot hold the cloth";
        }
        EXPECT_EQ(error.false_contacts > 0, level < 3);
    }
    EXPECT_EQ(before.distance, 0) << "level 3 are the leaves";
}

TEST(LongLimitedSearch, NeverExceedsItsBudgetAndIsBetterTheLargerThatIs) {
    Error before{.distance = 1e9, .missed_penetration = 1e9};
    for (const int tests : {1, 5, 16, 40, 85}) {
        const Error error = error_of_drop("search_tests=" + std::to_string(tests));
        EXPECT_EQ(error.status, Status::Ok) << tests;
        EXPECT_LE(error.most_tests, tests);
        EXPECT_LT(error.missed_penetration, before.missed_penetration + slop) << tests;
        EXPECT_LT(error.distance, before.distance) << tests;
        before = error;
    }
    EXPECT_EQ(before.distance, 0) << "85 nodes are all there are";
}

TEST(SearchAudit, TellsTrueNodesFromFalse) {
    // Two nodes side by side over a flat cloth, and a ball that reaches into the left one only
    const Grid grid{5, 3};
    Points x(grid.particles(), 3);
    for (int p = 0; p < grid.particles(); ++p) x.row(p) << Real(p % 5), 0, Real(p / 5);
    const StoppedNode left{{.i0 = 0, .j0 = 0, .i1 = 2, .j1 = 2}, {Vec3(1, 0, 1), Real(1.5)}, 1};
    const StoppedNode right{{.i0 = 2, .j0 = 0, .i1 = 4, .j1 = 2}, {Vec3(3, 0, 1), Real(1.5)}, 3};
    const Ball ball{.centre = Vec3(Real(1.4), Real(0.2), 1), .radius = Real(0.5)};
    SearchAudit audit(grid, Kernels::Vector);
    EXPECT_EQ(audit.false_contacts(x, ball, 0, std::vector{left}), 0);
    EXPECT_EQ(audit.false_contacts(x, ball, 0, std::vector{left, right}), 1);
    EXPECT_EQ(audit.false_contacts(x, ball, Real(0.2), std::vector{left, right}), 0) << "so thick it reaches the right";
    EXPECT_NEAR(audit.penetration(x, std::vector{ball}, 0), 0.3, 1e-6);
    const Ball beyond{.centre = Vec3(Real(2.45), Real(0.1), 1), .radius = Real(0.4)};
    EXPECT_EQ(audit.false_contacts(x, beyond, 0, std::vector{left}), 1) << "it reaches the next column only";
    EXPECT_EQ(audit.penetration(x, std::vector{Ball{.centre = Vec3(0, 9, 0), .radius = 1}}, 0), 0);
}

}  // namespace
}  // namespace drape
