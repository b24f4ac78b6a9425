// Broad phase and first touches together: every swept query gives the impacts that all cells give.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drape/base/exact_math.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/bounds/limited_quadtree.h"
#include "drape/contact/impact.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

struct SweptTally {
    long queries = 0, hits = 0, wrong = 0, cells = 0, cells_in_all = 0;
};

/// A cloth that goes from shape to shape, as a step does: slowly in one half, or all of it at once.
class SweptSteps {
public:
    SweptSteps(const Grid& grid, Real scale, unsigned seed) : random(seed), grid_(grid), scale_(scale) {
        to = scale * test::random_cloth(grid, random);
    }

    void go_on(int frame) {
        from = to;
        const Points aim = scale_ * test::random_cloth(grid_, random);
        const Real part = std::array{Real(0), Real(1e-3), Real(0.02), Real(0.3)}[static_cast<std::size_t>(frame) % 4];
        const int rows = frame % 3 == 0 ? grid_.particles() / 2 : grid_.particles();
        to.topRows(rows) += part * (aim - to).topRows(rows);
    }

    /// Anywhere, or past a particle at some time of the step that it then just touches.
    SweptBall shoot() {
        const Real size = std::abs(draw()), radius = scale_ * Real(0.005) * (1 + 20 * size * size);
        if (random() % 3 == 0) return {scale_ * point(), scale_ * point(), radius};
        const auto particle = static_cast<Eigen::Index>(random() % static_cast<unsigned>(to.rows()));
        const Real time = std::array{Real(0), Real(1), size}[random() % 3];
        const Vec3 touched = ((1 - time) * from.row(particle) + time * to.row(particle)).transpose();
        const Vec3 centre = touched + radius * (1 - Real(1e-3) * size) * point().normalized();
        const Vec3 way = (random() % 2 == 0 ? scale_ : Real(0.01) * scale_) * point();
        return {centre - time * way, centre + (1 - time) * way, radius};
    }

    std::mt19937 random;
    Points from, to;

private:
    Real draw() { return draw_even<Real>(random); }
    Vec3 point() { return Real(0.7) * Vec3(draw(), draw(), draw()); }

    Grid grid_;
    Real scale_;
};

/// Whether a tree finds what all cells have.
class SweptComparison {
public:
    explicit SweptComparison(const Grid& grid) : grid_(grid) { list_all_cells(grid, all_); }

    void compare(BroadPhase& tree, const Points& from, const Points& to, const SweptBall& ball) {
        tree.query(ball, found_);
        const auto order = [](const TriangleImpact& a, const TriangleImpact& b) { return a.triangle < b.triangle; };
        impacts_.clear(), expected_.clear();
        find_impacts(grid_, from, to, ball, found_.cells, impacts_);
        find_impacts(grid_, from, to, ball, all_, expected_);
        std::ranges::sort(impacts_, order);
        ++tally.queries;
        tally.hits += !expected_.empty();
        tally.wrong +=
            !std::ranges::equal(impacts_, expected_, {}, &TriangleImpact::triangle, &TriangleImpact::triangle);
        for (const CellRun& run : found_.cells) tally.cells += run.count;
        tally.cells_in_all += grid_.cells();
    }

    SweptTally tally;

private:
    Grid grid_;
    std::vector<CellRun> all_;
    Candidates found_;
    std::vector<TriangleImpact> impacts_, expected_;
};

/// How a tree is told of a step.
using BuildStep = void (*)(BroadPhase&, const Points& from, const Points& to);

SweptTally follow_steps(BroadPhase& tree, const Grid& grid, Real scale, int frames, BuildStep build) {
    SweptSteps steps(grid, scale, static_cast<unsigned>(grid.nx + 31 * grid.ny));
    SweptComparison comparison(grid);
    for (int frame = 0; frame < frames; ++frame) {
        steps.go_on(frame);
        build(tree, steps.from, steps.to);
        for (int shot = 0; shot < 60; ++shot) comparison.compare(tree, steps.from, steps.to, steps.shoot());
    }
    return comparison.tally;
}

template <class V>
class SweptQuadtree : public ::testing::Test {
protected:
    /// Over every update.
    static SweptTally compare_all(BuildStep build) {
        SweptTally sum;
        for (const UpdateKind update : test::all_updates()) {
            for (const auto& [grid, scale] : {std::pair{Grid{9, 9}, 1.0}, {Grid{31, 17}, 1e3}, {Grid{2, 60}, 1e-3}}) {
                ClothQuadtree<V> tree(grid, {.update = update, .leaf_cells = 2});
                const SweptTally tally = follow_steps(tree, grid, static_cast<Real>(scale), 24, build);
                sum.queries += tally.queries, sum.hits += tally.hits, sum.wrong += tally.wrong;
                sum.cells += tally.cells, sum.cells_in_all += tally.cells_in_all;
            }
        }
        return sum;
    }
};

TYPED_TEST_SUITE(SweptQuadtree, test::AllVolumes, test::VolumeNames);

TYPED_TEST(SweptQuadtree, NeverMissesAnImpactByAnyUpdate) {
    const SweptTally tally =
        this->compare_all([](BroadPhase& tree, const Points& from, const Points& to) { tree.build(from, to); });
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.hits, tally.queries / 2);
    EXPECT_LT(tally.hits, tally.queries * 9 / 10);
    EXPECT_LT(tally.cells, tally.cells_in_all / 2) << "a search of everything would find everything";
}

template <class Volume>
class NightlySweptQuadtree : public SweptQuadtree<Volume> {};

TYPED_TEST_SUITE(NightlySweptQuadtree, test::AllVolumes, test::VolumeNames);

/// The planted fault: a tree that is fitted to the end of the step alone.
TYPED_TEST(NightlySweptQuadtree, IsCaughtWhenItIsFittedToTheEndOfTheStepOnly) {
    const auto fault = [](BroadPhase& tree, const Points&, const Points& to) { tree.build(to); };
    EXPECT_GT(this->compare_all(fault).wrong, 20);
}

/// Another: to the beginning alone.
TYPED_TEST(NightlySweptQuadtree, IsCaughtWhenItIsFittedToTheBeginningOfTheStepOnly) {
    const auto fault = [](BroadPhase& tree, const Points& from, const Points&) { tree.build(from); };
    EXPECT_GT(this->compare_all(fault).wrong, 20);
}

TYPED_TEST(SweptQuadtree, ContainsBothEndsOfEveryStep) {
    const Grid grid{31, 17};
    for (const UpdateKind update : test::all_updates()) {
        ClothQuadtree<TypeParam> tree(grid, {.update = update, .leaf_cells = 3});
        SweptSteps steps(grid, 1, 3);
        for (int frame = 0; frame < 12; ++frame) {
            steps.go_on(frame);
            tree.build(steps.from, steps.to);
            for (const Points* x : {&steps.from, &steps.to}) {
                ASSERT_EQ(test::breaches<TypeParam>(grid, tree.nodes(), tree.volumes(), tree.slack(), *x), 0)
                    << names_of<UpdateKind>()[static_cast<std::size_t>(update)] << ", frame " << frame;
            }
            if (update != UpdateKind::Refit && update != UpdateKind::None) {
                EXPECT_EQ(tree.slack(), 0);
            }
        }
    }
}

/// A ball that stands still is one: whatever the discrete query finds, the swept one does.
TYPED_TEST(SweptQuadtree, FindsForAStandingBallWhatTheDiscreteQueryFinds) {
    const Grid grid{31, 17};
    SweptSteps steps(grid, 1, 4);
    ClothQuadtree<TypeParam> tree(grid, {.leaf_cells = 2});
    steps.go_on(0);
    tree.build(steps.from, steps.to);
    Candidates still, swept;
    for (int shot = 0; shot < 2000; ++shot) {
        const SweptBall ball = steps.shoot();
        tree.query({.centre = ball.start, .radius = ball.radius}, still);
        tree.query({ball.start, ball.start, ball.radius}, swept);
        std::ranges::sort(still.cells), std::ranges::sort(swept.cells);
        ASSERT_TRUE(std::ranges::includes(swept.cells, still.cells));
    }
}

TEST(LimitedSweptSearch, HandsOnNodesThatHoldEveryImpact) {
    const Grid grid{31, 17};
    LimitedQuadtree<BoundingSphere> tree(grid, {.leaf_cells = 2, .search = {.level = 2}});
    SweptSteps steps(grid, 1, 5);
    std::vector<CellRun> all;
    list_all_cells(grid, all);
    Candidates found;
    std::vector<TriangleImpact> expected;
    long hits = 0;
    for (int frame = 0; frame < 20; ++frame) {
        steps.go_on(frame);
        tree.build(steps.from, steps.to);
        for (int shot = 0; shot < 60; ++shot) {
            const SweptBall ball = steps.shoot();
            tree.query(ball, found);
            expected.clear();
            find_impacts(grid, steps.from, steps.to, ball, all, expected);
            for (const TriangleImpact& impact : expected) {
                const int cell = impact.triangle / 2, i = cell % grid.cell_columns(), j = cell / grid.cell_columns();
                ASSERT_TRUE(std::ranges::any_of(found.stopped, [&](const StoppedNode& node) {
                    return i >= node.i0 && i < node.i1 && j >= node.j0 && j < node.j1;
                }));
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, 1000);
}

/// The box that cells are left out by leaves out no impact that a triangle by itself has.
TEST(FindImpacts, LeavesOutNoTriangle) {
    const Grid grid{9, 9};
    SweptSteps steps(grid, 1, 6);
    std::vector<CellRun> all;
    list_all_cells(grid, all);
    std::vector<TriangleImpact> impacts;
    long hits = 0;
    for (int frame = 0; frame < 100; ++frame) {
        steps.go_on(frame);
        const SweptBall ball = steps.shoot();
        impacts.clear();
        find_impacts(grid, steps.from, steps.to, ball, all, impacts);
        auto next = impacts.begin();
        for (int t = 0; t < grid.triangles(); ++t) {
            std::array<Vec3, 3> from, to;
            for (std::size_t k = 0; k < 3; ++k) {
                from[k] = steps.from.row(grid.triangle_corners(t)[k]).transpose();
                to[k] = steps.to.row(grid.triangle_corners(t)[k]).transpose();
            }
            const auto impact = first_impact(ball, from, to);
            ASSERT_EQ(impact.has_value(), next != impacts.end() && next->triangle == t);
            if (!impact) continue;
            EXPECT_EQ(next->impact.time, impact->time);
            EXPECT_EQ(next->corners, grid.triangle_corners(t));
            ++next, ++hits;
        }
    }
    EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace drape
