// The hierarchy's experiment: its parts, and a share of it run as a program.

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "drape/base/input_error.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "lab/experiment/experiment_table.h"
#include "lab/experiments.h"
#include "lab/hierarchy/hierarchy_run.h"
#include "lab/lab_run.h"
#include "support/cloths.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

/// A ball that moves along a rumpled cloth and always touches it.
RecordedMotion rumpled_motion(const Grid& grid, int frames) {
    std::mt19937 random(5);
    RecordedMotion motion{.scene = "rumpled", .grid = grid, .interval = 0.01};
    const Points from = test::random_cloth(grid, random), to = test::random_cloth(grid, random);
    for (int k = 0; k < frames; ++k) {
        const Real part = static_cast<Real>(k) / static_cast<Real>(10 * frames);
        motion.x.emplace_back((1 - part) * from + part * to);
        const int p = grid.particle(2 + k % (grid.nx - 4), grid.ny / 2);
        motion.balls.push_back({.centre = motion.x.back().row(p).transpose(), .radius = Real(0.08)});
    }
    return motion;
}

TEST(Tightness, IsOneForTheSmallestVolumesOfTheirKind) {
    const RecordedMotion motion = rumpled_motion({13, 9}, 1);
    for (const BroadPhaseParameters& smallest :
         {BroadPhaseParameters{.volume = VolumeKind::Sphere, .leaf_cells = 2, .sphere_fit = SphereFit::Welzl},
          {.volume = VolumeKind::Aabb, .update = UpdateKind::Merge, .leaf_cells = 2},
          {.volume = VolumeKind::Kdop26, .update = UpdateKind::Merge, .leaf_cells = 2},
          {.volume = VolumeKind::Obb, .leaf_cells = 2}}) {
        const auto hierarchy = make_broad_phase(smallest, motion.grid);
        hierarchy->build(motion.x[0]);
        const Row tightness = tightness_of(*hierarchy, motion.grid, motion.x[0]);
        for (int level = 0; level < hierarchy->levels(); ++level) {
            EXPECT_NEAR(tightness.number("tightness_" + std::to_string(level)), 1, 1e-9);
        }
    }
}

/// The planted fault: every node 3 percent too large.
BoundingSphere fit_swollen_sphere(const Patch& patch) {
    BoundingSphere sphere = fit_smallest_sphere(patch);
    sphere.radius *= Real(1.03);
    return sphere;
}

TEST(Tightness, TellsByHowMuchNodesAreTooLarge) {
    const RecordedMotion motion = rumpled_motion({13, 9}, 2);
    ClothQuadtree<BoundingSphere> swollen(motion.grid, {.leaf_cells = 2}, {.patch = fit_swollen_sphere});
    swollen.build(motion.x[0]);
    EXPECT_NEAR(tightness_of(swollen, motion.grid, motion.x[0]).number("tightness"), 1.03, 1e-9);

    // What a held tree is grown by counts: here half the size of its leaves
    const auto held =
        make_broad_phase({.volume = VolumeKind::Aabb, .update = UpdateKind::None, .leaf_cells = 100}, motion.grid);
    held->build(motion.x[0]);
    Points shifted = motion.x[0];
    shifted.col(0).array() += Real(0.1);
    held->build(shifted);
    const Real half_width = (shifted.colwise().maxCoeff() - shifted.colwise().minCoeff()).mean() / 2;
    const Row of_held = tightness_of(*held, motion.grid, shifted);
    EXPECT_NEAR(of_held.number("tightness"), 1 + 0.1 / static_cast<double>(half_width), 1e-6);
}

/// The planted fault: every node too small by half.
BoundingSphere fit_shrunken_sphere(const Patch& patch) {
    BoundingSphere sphere = fit_smallest_sphere(patch);
    sphere.radius /= 2;
    return sphere;
}

TEST(HierarchyRun, EndsWhereAQueryDisagreesWithBruteForce) {
    const RecordedMotion motion = rumpled_motion({21, 15}, 6);
    for (const SearchLimit& limit : {SearchLimit{}, {.level = 2}, {.tests = 9}}) {
        const auto hierarchy = make_broad_phase({.leaf_cells = 2, .search = limit}, motion.grid);
        EXPECT_NO_THROW(follow(motion, *hierarchy, {.repeats = 1}));
    }
    ClothQuadtree<BoundingSphere> shrunken(motion.grid, {.leaf_cells = 2}, {.patch = fit_shrunken_sphere});
    try {
        follow(motion, shrunken, {.repeats = 1});
        ADD_FAILURE() << "it misses nothing";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), MatchesRegex("rumpled, frame [0-9]: triangle [0-9]+ touches the ball, and .*"));
    }
}

TEST(RecordedMotion, IsWhatTheSceneIsBuiltFromAndTheSameSurfaceOnFinerGrids) {
    MotionWanted wanted{.scene = "drop", .from = 0.1, .interval = 0.01, .frames = 3};
    Motions motions;
    const RecordedMotion motion = find_motion(motions, wanted);
    ASSERT_EQ(motion.x.size(), 3u);
    ASSERT_EQ(motion.balls.size(), 3u);
    EXPECT_NEAR(motion.interval, 0.01, 2e-4) << "a whole number of steps";
    EXPECT_NEAR(static_cast<double>(motion.balls[0].radius), 0.302, 1e-6) << "grown by the thickness";

    // It falls freely until after the second frame; in the third, contact has pushed back what was recorded before
    Simulation simulation("drop", load_scene("drop"));
    const double dt = simulation.settings().solver.dt;
    const auto first = std::llround(0.1 / dt), between = std::llround(0.01 / dt);
    for (auto step = first + 1; step > 0; --step) simulation.step();
    EXPECT_EQ(motion.x[0], simulation.cloths()[0].state.x);
    for (auto step = 2 * between; step > 0; --step) simulation.step();
    ASSERT_GT(simulation.report().contacts, 0);
    EXPECT_NE(motion.x[2], simulation.cloths()[0].state.x);
    EXPECT_LT((motion.x[2] - simulation.cloths()[0].state.x).cwiseAbs().maxCoeff(), 1e-3);

    wanted.side = 59;
    const RecordedMotion finer = find_motion(motions, wanted);
    for (int j = 0; j < 30; ++j) {
        for (int i = 0; i < 30; ++i) {
            const int coarse = motion.grid.particle(i, j), fine = finer.grid.particle(2 * i, 2 * j);
            EXPECT_LT((motion.x[2].row(coarse) - finer.x[2].row(fine)).norm(), 1e-12);
        }
    }
}

TEST(LabHierarchy, WritesWhatItCountsAndDrawsWhatAShareHas) {
    const LabFolder folder;
    const std::string all = std::to_string(hierarchy_experiment().cases(true).size());
    const LabRun run = folder.run({"hierarchy", "--quick", "--share", "2/" + all, "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const Experiment hierarchy = hierarchy_experiment();
    const Rows rows = read_table(hierarchy, folder.path("out/hierarchy.csv")).value().rows();
    ASSERT_EQ(rows.size(), 3u) << "three sizes of leaves";
    for (const Row& row : rows) {
        EXPECT_GE(row.number("candidates"), row.number("touching"));
        EXPECT_GT(row.number("build_s"), 0);
        EXPECT_LE(row.number("build_lower_s"), row.number("build_s"));
        EXPECT_GT(row.number("touching"), 1);
        EXPECT_GT(row.number("tightness"), 1);
        EXPECT_LT(row.number("tightness"), 1.2);
    }
    EXPECT_LT(rows[0].number("false_per_true"), rows[2].number("false_per_true")) << "smaller leaves leave out more";
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(folder.read("out/hierarchy_fit.svg"), HasSubstr("</svg>"));
    EXPECT_FALSE(folder.has("out/hierarchy_size.svg"));
    const std::string page = folder.read("out/hierarchy.html");
    EXPECT_THAT(page, HasSubstr("hierarchy_fit.svg"));
    EXPECT_THAT(page, Not(HasSubstr("hierarchy_storage.svg"))) << "nothing of it is in the share";
}

}  // namespace
}  // namespace drape
