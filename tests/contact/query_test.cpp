// Broad phase and exact test together: every query gives the triangles that brute force gives.

#include <gtest/gtest.h>

#include <algorithm>

#include "drape/bounds/bounding_sphere.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/contact/contact.h"
#include "support/cloths.h"

namespace drape {
namespace {

/// Counts the configurations of cloth and ball in which a hierarchy and brute force disagree.
template <class Volume>
class Comparison {
public:
    explicit Comparison(const Grid& grid, int leaf_cells, Fits<Volume> fits)
        : grid_(grid), tree_(grid, {.leaf_cells = leaf_cells}, fits) {
        brute_ = make_broad_phase({.volume = VolumeKind::Brute}, grid);
    }

    void build(const Points& x, Real thickness) {
        x_ = &x;
        thickness_ = thickness;
        tree_.build(x);
        brute_->build(x);
    }

    void compare(const Ball& ball) {
        ++configurations;
        tree_.query(grown(ball, thickness_), candidates_);
        find_touched_triangles(grid_, *x_, ball, thickness_, candidates_.cells, found_);
        brute_->query(ball, candidates_);
        find_touched_triangles(grid_, *x_, ball, thickness_, candidates_.cells, expected_);
        std::sort(found_.begin(), found_.end());
        if (found_ != expected_) ++disagreements;
        if (!expected_.empty()) ++touching;
    }

    /// A ball that touches a random node's farthest particle from outside, by a millionth of its radius.
    Ball just_touching(std::mt19937& random, Real radius) const {
        const std::size_t n = random() % tree_.nodes().size();
        const QuadtreeNode& node = tree_.nodes()[n];
        const Vec3 centre = tree_.volumes()[n].centre;
        Vec3 farthest = centre;
        for (int j = node.j0; j <= node.j1; ++j) {
            for (int i = node.i0; i <= node.i1; ++i) {
                const Vec3 p = x_->row(grid_.particle(i, j)).transpose();
                if ((p - centre).norm() > (farthest - centre).norm()) farthest = p;
            }
        }
        const Vec3 outward = (farthest - centre).normalized();
        return {.centre = farthest + outward * ((radius + thickness_) * (1 - 1e-6)), .radius = radius};
    }

    long configurations = 0, disagreements = 0, touching = 0;

private:
    Grid grid_;
    ClothQuadtree<Volume> tree_;
    std::unique_ptr<BroadPhase> brute_;
    const Points* x_ = nullptr;
    Real thickness_ = 0;
    Candidates candidates_;
    std::vector<int> found_, expected_;
};

/// Half of the balls anywhere about the cloth, half just touching.
template <class Volume>
Comparison<Volume> compare_many(const Grid& grid, int leaf_cells, int cloths, int balls, Real scale,
                                Fits<Volume> fits = {}) {
    std::mt19937 random(static_cast<unsigned>(grid.nx * 1000 + grid.ny + leaf_cells));
    std::uniform_real_distribution<Real> unit(-1, 1);
    Comparison<Volume> comparison(grid, leaf_cells, fits);
    for (int cloth = 0; cloth < cloths; ++cloth) {
        const Points x = scale * testing::random_cloth(grid, random);
        comparison.build(x, cloth % 2 == 0 ? Real(0) : Real(0.003) * scale);
        for (int ball = 0; ball < balls; ++ball) {
            const Real radius = scale * Real(0.02) * std::exp(2 * (1 + unit(random)));
            const Vec3 anywhere = scale * Real(0.8) * Vec3(unit(random), unit(random), unit(random));
            comparison.compare(ball % 2 == 0 ? Ball{.centre = anywhere, .radius = radius}
                                             : comparison.just_touching(random, radius));
        }
    }
    return comparison;
}

TEST(SphereQuadtree, NeverMissesATouchedTriangleInAMillionConfigurations) {
    long configurations = 0, touching = 0;
    const auto run = [&](const Grid& grid, int leaf_cells, int cloths, Real scale) {
        const auto comparison = compare_many<BoundingSphere>(grid, leaf_cells, cloths, 500, scale);
        EXPECT_EQ(comparison.disagreements, 0) << grid.nx << " x " << grid.ny << ", leaf " << leaf_cells;
        configurations += comparison.configurations;
        touching += comparison.touching;
    };
    run({9, 9}, 2, 600, 1);
    run({9, 9}, 1, 400, 1e6);
    run({12, 7}, 4, 500, 1e-6);
    run({2, 20}, 1, 300, 1);
    run({17, 13}, 4, 180, 1);
    run({31, 17}, 4, 30, 1);
    EXPECT_GE(configurations, 1'000'000);
    EXPECT_GE(touching, configurations / 2);
}

/// The planted fault: every node one percent too small.
BoundingSphere fit_shrunken_sphere(const Patch& patch) {
    BoundingSphere sphere = BoundingSphere::fit(patch);
    sphere.radius *= Real(0.99);
    return sphere;
}

TEST(SphereQuadtree, IsCaughtWhenItsNodesAreOnePercentTooSmall) {
    EXPECT_GT(compare_many<BoundingSphere>({9, 9}, 2, 20, 500, 1, {.patch = fit_shrunken_sphere}).disagreements, 100);
}

}  // namespace
}  // namespace drape
