// Hierarchies and exact tests of both kernels find the same triangles, and the same contacts to the bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drape/bounds/broad_phase.h"
#include "drape/bounds/displacement.h"
#include "drape/contact/detection.h"
#include "support/cloths.h"

namespace drape {
namespace {

/// What both ways find of one ball.
class BothWays {
public:
    BothWays(BroadPhaseParameters parameters, const Grid& grid) : grid_(grid) {
        vector_.tree = make_broad_phase(parameters, grid);
        parameters.kernels = Kernels::Plain;
        plain_.kernels = Kernels::Plain;
        plain_.tree = make_broad_phase(parameters, grid);
    }

    void build(const Points& x) {
        for (Way* way : {&vector_, &plain_}) way->tree->build(x);
    }

    /// @param before positions at the start of the substep, for a ball that has moved
    bool agree(const Points& before, const Points& x, const Ball& ball) {
        const Real moved = ball.moved.norm();
        const Real reach = moved > 0 ? moved + largest_displacement(x, before) : Real(0);
        for (Way* way : {&vector_, &plain_}) {
            way->tree->query(grown(ball, thickness_ + 2 * reach), way->found);
            std::ranges::sort(way->found.cells, {}, &CellRange::first);
            way->contacts.clear();
        }
        for (Way* way : {&vector_, &plain_}) {
            find_touched_triangles(grid_, x, ball, thickness_, way->found.cells, way->triangles, way->kernels);
            way->touching = find_contacts({grid_, before, x}, ball, {0, thickness_, reach}, way->found.cells,
                                          way->contacts, way->kernels);
        }
        touching += plain_.touching > 0;
        return vector_.triangles == plain_.triangles && vector_.touching == plain_.touching &&
               std::ranges::equal(vector_.contacts, plain_.contacts, [&](const ContactRow& a, const ContactRow& b) {
                   return compare(a, b) == 0 && a.point(x) == b.point(x) && a.normal == b.normal && a.depth == b.depth;
               });
    }

    int touching = 0;

private:
    struct Way {
        Kernels kernels = Kernels::Vector;
        std::unique_ptr<BroadPhase> tree;
        Candidates found;
        std::vector<int> triangles;
        std::vector<ContactRow> contacts;
        std::int64_t touching = 0;
    };
    static constexpr Real thickness_ = Real(0.002);
    Grid grid_;
    Way vector_, plain_;
};

struct Tally {
    int balls = 0, disagreements = 0, touching = 0;
};

Tally compare(const BroadPhaseParameters& parameters, const Grid& grid) {
    std::mt19937 random(static_cast<unsigned>(grid.particles()));
    std::uniform_real_distribution<Real> unit(-1, 1);
    BothWays both(parameters, grid);
    Points x = test::random_cloth(grid, random);
    Tally tally;
    for (int frame = 0; frame < 10; ++frame) {
        const Points before = x;
        for (Real& coordinate : x.reshaped()) coordinate += Real(0.01) * unit(random);
        both.build(x);
        for (int k = 0; k < 20; ++k, ++tally.balls) {
            Ball ball{.centre = Real(0.6) * Vec3(unit(random), unit(random), unit(random)),
                      .radius = Real(0.25) + Real(0.2) * unit(random)};
            if (k % 2 == 1) ball.moved = Real(0.3) * Vec3(unit(random), unit(random), unit(random));
            tally.disagreements += !both.agree(before, x, ball);
        }
    }
    tally.touching = both.touching;
    return tally;
}

constexpr Grid shapes[] = {{2, 2}, {14, 9}, {2, 30}, {33, 3}};

TEST(PlainCore, FindsWhatTheKernelsFindWithEveryVolumeSphereFitAndUpdate) {
    std::vector<BroadPhaseParameters> cases;
    for (const UpdateKind update : values_of<UpdateKind>()) {
        for (const VolumeKind volume : values_of<VolumeKind>()) {
            cases.push_back({.volume = volume, .update = update, .leaf_cells = 3});
        }
        for (const SphereFit fit : values_of<SphereFit>()) {
            cases.push_back({.update = update, .leaf_cells = 2, .sphere_fit = fit});
        }
    }
    Tally sum;
    for (const BroadPhaseParameters& one : cases) {
        for (const Grid& grid : shapes) {
            const Tally tally = compare(one, grid);
            EXPECT_EQ(tally.disagreements, 0)
                << name_of(one.volume) << ", " << name_of(one.update) << ", " << name_of(one.sphere_fit);
            sum.balls += tally.balls, sum.touching += tally.touching;
        }
    }
    EXPECT_GT(sum.touching, sum.balls / 5);
    EXPECT_LT(sum.touching, sum.balls);
}

TEST(PlainCore, FindsWhatTheKernelsFindInLeavesOfEveryWidth) {
    for (const int leaf_cells : {7, 8, 15, 16, 17, 31, 32, 33, 64}) {
        const Tally tally =
            compare({.volume = VolumeKind::Aabb, .update = UpdateKind::Merge, .leaf_cells = leaf_cells}, {70, 40});
        EXPECT_EQ(tally.disagreements, 0) << "leaves of " << leaf_cells;
        EXPECT_GT(tally.touching, tally.balls / 5);
    }
}

/// A row of particles has positions that are no numbers, as in a motion that has diverged: what is found of the others
/// does not change. The cells before it are longer than the ball is wide, and those behind it short.
TEST(PlainCore, FindsWhatTheKernelsFindBesidePositionsThatAreNoNumbers) {
    const Grid grid{40, 16};
    std::mt19937 random(57);
    std::uniform_real_distribution<Real> unit(0, 1);
    const std::vector<CellRange> all{all_cells(grid)};
    Points x(grid.particles(), 3);
    for (int p = 0; p < grid.particles(); ++p) {
        const int i = p % grid.nx, j = p / grid.nx;
        x.row(p) << static_cast<Real>(i) / 40, 0, 1 - std::pow(Real(0.8), static_cast<Real>(j));
        if (j == 10) x(p, p % 3) = std::numeric_limits<Real>::quiet_NaN();
    }
    int touching = 0;
    for (int round = 0; round < 200; ++round) {
        const Ball ball{.centre = Vec3(unit(random), 0, unit(random)), .radius = Real(0.05)};
        std::array<std::vector<int>, 2> found;
        for (const Kernels kernels : {Kernels::Plain, Kernels::Vector}) {
            std::vector<int>& triangles = found[kernels == Kernels::Vector];
            find_touched_triangles(grid, x, ball, 0, all, triangles, kernels);
            std::erase_if(triangles, [&](int triangle) {
                const auto corners = grid.triangle_corners(triangle);
                return std::ranges::any_of(corners, [&](int c) { return !x.row(c).allFinite(); });
            });
        }
        EXPECT_EQ(found[0], found[1]);
        touching += !found[0].empty();
    }
    EXPECT_GT(touching, 100);
}

}  // namespace
}  // namespace drape
