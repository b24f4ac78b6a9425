// Broad phase and exact test together: every query gives the triangles that brute force gives.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "drape/bounds/bounding_sphere.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/bounds/kdop.h"
#include "drape/bounds/obb.h"
#include "drape/contact/detection.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

/// Counts the configurations of cloth and ball in which a hierarchy and brute force disagree.
template <class Volume>
class Comparison {
public:
    explicit Comparison(const Grid& grid, const BroadPhaseParameters& parameters)
        : grid_(grid), tree_(grid, parameters) {
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
        find_touched_triangles(grid_, *x_, ball, thickness_, candidates_.cells, found_, Kernels::Vector);
        brute_->query(ball, candidates_);
        find_touched_triangles(grid_, *x_, ball, thickness_, candidates_.cells, expected_, Kernels::Vector);
        std::sort(found_.begin(), found_.end());
        if (found_ != expected_) ++disagreements;
        if (!expected_.empty()) ++touching;
    }

    /// A ball that touches a random node's farthest particle from outside, by a fraction of its radius; a negative
    /// fraction misses it.
    Ball just_touching(std::mt19937& random, Real radius, Real fraction = Real(1e-6)) const {
        const std::size_t n = random() % tree_.nodes().size();
        const QuadtreeNode& node = tree_.nodes()[n];
        const Vec3 centre = tree_.volumes()[n].sphere().centre;
        Vec3 farthest = centre;
        for (int j = node.j0; j <= node.j1; ++j) {
            for (int i = node.i0; i <= node.i1; ++i) {
                const Vec3 p = x_->row(grid_.particle(i, j)).transpose();
                if ((p - centre).norm() > (farthest - centre).norm()) farthest = p;
            }
        }
        return beside(farthest, farthest - centre, radius, fraction);
    }

    /// The same, from a random side at the particle that is outermost there.
    Ball touching_from_a_side(std::mt19937& random, Real radius, Real fraction) const {
        std::uniform_int_distribution<int> sign(-1, 1);
        std::normal_distribution<Real> normal;
        Vec3 side(sign(random), sign(random), sign(random));
        if (random() % 2 == 0 || side.isZero(0)) side = Vec3(normal(random), normal(random), normal(random));
        Eigen::Index outermost = 0;
        (*x_ * side).maxCoeff(&outermost);
        return beside(x_->row(outermost).transpose(), side, radius, fraction);
    }

    long configurations = 0, disagreements = 0, touching = 0;

private:
    Ball beside(const Vec3& point, const Vec3& outward, Real radius, Real fraction) const {
        return {.centre = point + outward.normalized() * ((radius + thickness_) * (1 - fraction)), .radius = radius};
    }

    Grid grid_;
    ClothQuadtree<Volume> tree_;
    std::unique_ptr<BroadPhase> brute_;
    const Points* x_ = nullptr;
    Real thickness_ = 0;
    Candidates candidates_;
    std::vector<int> found_, expected_;
};

/// A cloth that goes from shape to shape, one half faster than the other: slowly, so that a refit leaves what has
/// hardly moved, then fast.
Points moving_cloth(const Points& from, const Points& to, int frame) {
    Points x = from;
    const Real fraction = frame < 4 ? Real(0.001) * static_cast<Real>(frame) : Real(0.2) * static_cast<Real>(frame - 3);
    x.topRows(x.rows() / 2) += fraction * (to - from).topRows(x.rows() / 2);
    x.bottomRows(x.rows() / 4) += fraction * fraction * (to - from).bottomRows(x.rows() / 4);
    return x;
}

/// Follows a cloth through eight frames and asks about balls anywhere, just touching and just missing in each.
template <class Volume>
void follow(Comparison<Volume>& comparison, const Points& from, const Points& to, Real scale, int balls,
            std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    for (int frame = 0; frame < 8; ++frame) {
        const Points x = moving_cloth(from, to, frame);
        comparison.build(x, frame % 2 == 0 ? Real(0) : Real(0.003) * scale);
        for (int ball = 0; ball < balls; ++ball) {
            const Real radius = scale * Real(0.02) * std::exp(2 * (1 + unit(random)));
            const Real fraction = ball % 2 == 0 ? Real(1e-6) : Real(-1e-6);
            const Vec3 anywhere = scale * Real(0.8) * Vec3(unit(random), unit(random), unit(random));
            comparison.compare({.centre = anywhere, .radius = radius});
            comparison.compare(comparison.just_touching(random, radius, fraction));
            comparison.compare(comparison.touching_from_a_side(random, radius, fraction));
        }
    }
}

template <class Volume>
class Quadtree : public ::testing::Test {
protected:
    /// @return disagreements with brute force, over every update
    long compare(const Grid& grid, int leaf_cells, Real scale, int cloths, int balls) {
        long disagreements = 0;
        std::mt19937 random(static_cast<unsigned>(grid.nx + 7 * grid.ny + leaf_cells));
        for (const UpdateKind update : values_of<UpdateKind>()) {
            for (int cloth = 0; cloth < cloths; ++cloth) {
                Points from = scale * test::random_cloth(grid, random), to = scale * test::random_cloth(grid, random);
                if (cloth % 5 == 3) from.leftCols(2).setConstant(Real(0.1) * scale), to.leftCols(2).setZero();
                if (cloth % 5 == 4) from.setConstant(Real(0.1) * scale);
                Comparison<Volume> comparison(grid, {.update = update, .leaf_cells = leaf_cells});
                follow(comparison, from, to, scale, balls, random);
                disagreements += comparison.disagreements;
                configurations_ += comparison.configurations;
                touching_ += comparison.touching;
            }
        }
        return disagreements;
    }

    long configurations_ = 0, touching_ = 0;
};

TYPED_TEST_SUITE(Quadtree, test::UnlikeVolumes, test::VolumeNames);

TYPED_TEST(Quadtree, AgreesWithBruteForceInEveryUpdateAtAnyScale) {
    EXPECT_EQ(this->compare({9, 9}, 2, 1, 10, 40), 0);
    EXPECT_EQ(this->compare({9, 9}, 1, 1e6, 10, 30), 0);
    EXPECT_EQ(this->compare({12, 7}, 4, 1e-6, 10, 30), 0);
    EXPECT_EQ(this->compare({2, 2}, 4, 1, 10, 30), 0);
    EXPECT_EQ(this->compare({2, 60}, 1, 1, 5, 20), 0);
    EXPECT_EQ(this->compare({31, 17}, 4, 1, 5, 10), 0);
    EXPECT_GT(this->configurations_, 50'000);
    EXPECT_GT(this->touching_, this->configurations_ / 4);
    EXPECT_LT(this->touching_, this->configurations_ * 3 / 4);
}

/// Far from the origin the exact test rounds, and what it calls touching must have been a candidate.
TYPED_TEST(Quadtree, AgreesWithBruteForceToTheLastBitsFarFromTheOrigin) {
    std::mt19937 random(5);
    const Grid grid{9, 9};
    Comparison<TypeParam> comparison(grid, {.leaf_cells = 2});
    for (const Real offset : {Real(0), Real(10), Real(1e4)}) {
        const Points x = (test::random_cloth(grid, random).array() + offset).matrix();
        const Real bits = std::numeric_limits<Real>::epsilon() * (1 + offset);
        comparison.build(x, 0);
        for (int ball = 0; ball < 4000; ++ball) {
            const Real radius = Real(0.3), fraction = static_cast<Real>(ball % 9 - 4) * bits;
            comparison.compare(comparison.just_touching(random, radius, fraction));
            comparison.compare(comparison.touching_from_a_side(random, radius, fraction));
        }
    }
    EXPECT_EQ(comparison.disagreements, 0);
    EXPECT_GT(comparison.touching, comparison.configurations / 4);
    EXPECT_LT(comparison.touching, comparison.configurations);
}

}  // namespace
}  // namespace drape
