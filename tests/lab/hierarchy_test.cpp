// The hierarchy's experiment: its parts, and a share of it run as a program.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "drape/base/copied.h"
#include "drape/base/input_error.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/bounds/obb.h"
#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "lab/experiment/experiment_table.h"
#include "lab/experiments.h"
#include "lab/hierarchy/hierarchy.h"
#include "lab/hierarchy/hierarchy_run.h"
#include "lab/lab_run.h"
#include "support/cloths.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

/// A ball that moves along a rumpled cloth and always touches it.
RecordedMotion rumpled_motion(const Grid& grid, int frames) {
    std::mt19937 random(5);
    RecordedMotion motion{.scene = "rumpled", .grid = grid, .interval = 0.01, .x = {}, .balls = {}};
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
        std::vector<Tightness> levels;
        add_tightness(*hierarchy, motion.grid, motion.x[0], levels);
        ASSERT_EQ(levels.size(), static_cast<std::size_t>(hierarchy->levels()));
        for (const Tightness& level : levels) EXPECT_NEAR(level.mean(), 1, 1e-9);
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
    std::vector<Tightness> levels;
    add_tightness(swollen, motion.grid, motion.x[0], levels);
    EXPECT_NEAR(over_levels(levels).mean(), 1.03, 1e-9);
    EXPECT_EQ(over_levels(levels).nodes, static_cast<std::int64_t>(swollen.nodes().size()));

    // What a held tree is grown by counts: here half the size of its leaves
    const auto held =
        make_broad_phase({.volume = VolumeKind::Aabb, .update = UpdateKind::None, .leaf_cells = 100}, motion.grid);
    held->build(motion.x[0]);
    Points shifted = motion.x[0];
    shifted.col(0).array() += Real(0.1);
    held->build(shifted);
    const Real half_width = (shifted.colwise().maxCoeff() - shifted.colwise().minCoeff()).mean() / 2;
    levels.clear();
    add_tightness(*held, motion.grid, shifted, levels);
    EXPECT_NEAR(over_levels(levels).mean(), 1 + 0.1 / static_cast<double>(half_width), 1e-6);
}

TEST(BreakEven, IsTheFrameFromWhichOnMoreWasSpentInAll) {
    const std::vector<double> rebuild(6, 10);
    const auto frame = [&rebuild](const std::vector<double>& costs) { return break_even_frame(costs, rebuild); };
    EXPECT_EQ(frame({5, 8, 11, 14, 17, 20}), 4u) << "55 against 50 after the fifth";
    EXPECT_EQ(frame({9, 9, 9, 9, 9, 9}), std::nullopt);
    EXPECT_EQ(frame({10, 10, 10, 10, 10, 10}), std::nullopt) << "as much is not more";
    EXPECT_EQ(frame({11, 1, 10, 10, 10, 30}), 5u) << "ahead for a while does not count";
    EXPECT_EQ(frame({30, 1, 1, 1, 1, 1}), std::nullopt);
    EXPECT_EQ(frame({11, 11, 11, 11, 11, 11}), 0u);
}

/// The planted fault: a hierarchy that forgets, or invents, what it finds from some frame on.
class FaultyHierarchy final : public BroadPhase {
public:
    enum class Fault { None, MissesARun, ListsARunTwice, DropsAStoppedNode };
    FaultyHierarchy(const Grid& grid, Fault fault, int from_build, const SearchLimit& limit = {})
        : right_(make_broad_phase({.leaf_cells = 2, .search = limit}, grid)),
          fault_(fault),
          healthy_builds_(from_build) {}

    [[nodiscard]] std::unique_ptr<BroadPhase> clone() const override {
        return std::make_unique<FaultyHierarchy>(*this);
    }

    void build(const Points& x) override {
        right_->build(x);
        --healthy_builds_;
    }
    TraversalStats query(const Ball& ball, Candidates& found) override {
        const TraversalStats stats = right_->query(ball, found);
        if (healthy_builds_ >= 0) return stats;
        if (fault_ == Fault::MissesARun)
            std::erase_if(found.cells, [](const CellRun& run) { return run.row % 5 == 2; });
        if (fault_ == Fault::ListsARunTwice)
            found.cells.insert(found.cells.end(), found.cells.begin(), found.cells.end());
        if (fault_ == Fault::DropsAStoppedNode) found.stopped.clear();
        return stats;
    }
    TraversalStats query(const BroadPhase& other, Real margin, const FoldTest* folds,
                         std::vector<LeafPair>& pairs) override {
        return right_->query(other, margin, folds, pairs);
    }
    TraversalStats query_below(Real y, Candidates& found) const override { return right_->query_below(y, found); }
    TraversalStats query_near(const DistanceFunction& distance, Real margin, Candidates& found) const override {
        return right_->query_near(distance, margin, found);
    }
    [[nodiscard]] Real slack() const override { return right_->slack(); }
    [[nodiscard]] int levels() const override { return right_->levels(); }
    void nodes_at(int level, std::vector<NodeView>& nodes) const override { right_->nodes_at(level, nodes); }

private:
    Copied<BroadPhase> right_;
    Fault fault_;
    int healthy_builds_;
};

TEST(HierarchyRun, EndsWhereAQueryDisagreesWithBruteForce) {
    using enum FaultyHierarchy::Fault;
    const RecordedMotion motion = rumpled_motion({21, 15}, 6);
    const auto message = [&motion](FaultyHierarchy::Fault fault, const SearchLimit& limit = {}) -> std::string {
        FaultyHierarchy hierarchy(motion.grid, fault, 3, limit);
        try {
            follow(motion, hierarchy, {.repeats = 1});
        } catch (const RunError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_EQ(message(None), "nothing");
    EXPECT_EQ(message(None, {.level = 2}), "nothing");
    EXPECT_EQ(message(None, {.tests = 9}), "nothing");
    EXPECT_THAT(message(MissesARun), MatchesRegex("rumpled, frame 3: triangle [0-9]+ touches the ball, and .*"));
    EXPECT_THAT(message(ListsARunTwice), MatchesRegex("rumpled, frame 3: triangle [0-9]+ was found twice"));
    EXPECT_THAT(message(DropsAStoppedNode, {.level = 2}), HasSubstr("the search has missed it"));
}

TEST(HierarchyRun, CountsCandidatesAgainstTouchingCells) {
    const RecordedMotion motion = rumpled_motion({21, 15}, 4);
    const auto run_of = [&motion](const BroadPhaseParameters& parameters) {
        const auto hierarchy = make_broad_phase(parameters, motion.grid);
        return follow(motion, *hierarchy, {.repeats = 2});
    };
    const HierarchyRun brute = run_of({.volume = VolumeKind::Brute}), tree = run_of({.leaf_cells = 1}),
                       root = run_of({.leaf_cells = 1, .search = {.level = 0}});
    ASSERT_EQ(brute.counts.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(brute.counts[k].candidates, motion.grid.cells());
        EXPECT_EQ(root.counts[k].candidates, motion.grid.cells()) << "what the root holds counts";
        EXPECT_EQ(tree.counts[k].touching, brute.counts[k].touching);
        EXPECT_GT(tree.counts[k].touching, 0);
        EXPECT_LT(tree.counts[k].candidates, motion.grid.cells());
        EXPECT_EQ(tree.times[k].size(), 2u);
    }
    EXPECT_LT(false_per_true(tree.counts), false_per_true(brute.counts));
}

TEST(RecordedMotion, IsWhatTheSceneIsBuiltFromAndTheSameSurfaceOnFinerGrids) {
    const RecordedMotion motion = record_motion({.scene = "drop", .from = 0.1, .interval = 0.01, .frames = 3});
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

    const RecordedMotion finer = resampled(motion, {59, 59});
    for (int j = 0; j < 30; ++j) {
        for (int i = 0; i < 30; ++i) {
            const int coarse = motion.grid.particle(i, j), fine = finer.grid.particle(2 * i, 2 * j);
            EXPECT_LT((motion.x[2].row(coarse) - finer.x[2].row(fine)).norm(), 1e-12);
        }
    }
}

TEST(HierarchyRow, ReadsBackAsItWasWritten) {
    HierarchyRow row;
    row.part = "size", row.scene = "drop", row.volume = "sphere", row.sphere_fit = "ritter", row.update = "refit";
    row.particles = 1048576, row.build.median = 1.25e-3, row.distance_m = 0.5;
    const RowFormat<HierarchyRow> format = hierarchy_format();
    const TableRow written = format.cells(row);
    EXPECT_EQ(written.size(), format.columns().size());
    EXPECT_EQ(format.cells(format.row(written)), written);
    EXPECT_EQ(format.row(written).particles, 1048576);
    EXPECT_TRUE(std::isnan(format.row(written).level));
    EXPECT_EQ(row.variant(), "sphere ritter");
}

TEST(Growths, AreThoseOfTheLargerSizes) {
    std::vector<HierarchyRow> rows;
    for (const double particles : {256., 1024., 4096., 16384., 65536.}) {
        HierarchyRow row;
        row.part = "size", row.volume = "aabb", row.update = "merge";
        row.particles = particles;
        // Flat below 4096 particles, then as n and as the square root of n
        row.build.median = 1e-9 * std::max(particles, 4096.);
        row.query.median = 1e-8 * std::sqrt(std::max(particles, 4096.));
        row.exact.median = row.query.median;
        rows.push_back(row);
    }
    const std::vector<Growth> found = growths(rows);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].build.exponent, 1, 1e-9);
    EXPECT_NEAR(found[0].search.exponent, 0.5, 1e-9);
    EXPECT_TRUE(growths({rows[4]}).empty()) << "one size tells nothing";
}

/// Two cases of the quick experiment, one that brute force is measured in and one of spheres on the drop scene.
class LabHierarchy : public ::testing::Test {
protected:
    static LabRun run_share(const LabFolder& folder, int first, const std::string& out) {
        const std::string all = std::to_string(hierarchy_experiment().cases(true).size());
        return folder.run({"hierarchy", "--quick", "--share", std::to_string(first) + "/" + all, "--out", out});
    }

    static std::vector<HierarchyRow> rows_of(const LabFolder& folder, const std::string& file) {
        const auto table = read_table(hierarchy_experiment(), folder.path(file), false);
        return hierarchy_format().rows(table.value().rows());
    }
};

TEST_F(LabHierarchy, WritesTheSameCountsInEveryRun) {
    const LabFolder folder;
    for (const char* out : {"a", "b"}) {
        const LabRun run = run_share(folder, 2, out);
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr("fit: drop, 900 particles: fastest is sphere"));
    }
    const auto one = rows_of(folder, "a/hierarchy.csv"), other = rows_of(folder, "b/hierarchy.csv");
    ASSERT_EQ(one.size(), 3u) << "three sizes of leaves";
    ASSERT_EQ(other.size(), one.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_GT(one[k].build.median, 0);
        EXPECT_LE(one[k].build.lower, one[k].build.median);
        EXPECT_GT(one[k].touching, 1);
        EXPECT_GT(one[k].tightness, 1);
        EXPECT_LT(one[k].tightness, 1.2);
        for (const auto value : {&HierarchyRow::nodes, &HierarchyRow::visited, &HierarchyRow::candidates,
                                 &HierarchyRow::touching, &HierarchyRow::false_per_true, &HierarchyRow::tightness}) {
            EXPECT_EQ(one[k].*value, other[k].*value);
        }
    }
    EXPECT_LT(one[0].false_per_true, one[2].false_per_true) << "smaller leaves leave out more";
}

TEST_F(LabHierarchy, DrawsWhatAShareHas) {
    const LabFolder folder;
    const LabRun run = run_share(folder, 1, "out");
    ASSERT_EQ(run.code, 0) << run.err;
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(folder.read("out/hierarchy_fit.svg"), HasSubstr("</svg>"));
    EXPECT_FALSE(folder.has("out/hierarchy_size.svg"));
}

}  // namespace
}  // namespace drape
