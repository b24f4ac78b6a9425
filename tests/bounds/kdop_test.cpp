#include "drape/bounds/kdop.h"

#include <gtest/gtest.h>

#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

using test::whole;

/// Balls about a cloth, half of them touching its box from outside, to the rounding.
Ball random_ball(const Aabb& box, std::mt19937& random, bool touching) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    Ball ball{.centre = Vec3(unit(random), unit(random), unit(random)), .radius = Real(0.3) * std::abs(unit(random))};
    if (touching) {
        const Vec3 nearest = ball.centre.cwiseMax(box.low).cwiseMin(box.high);
        ball.radius = (ball.centre - nearest).norm();
    }
    return ball;
}

TEST(KDop, OfSixDecidesAsTheBox) {
    std::mt19937 random(31);
    int overlapping = 0;
    for (int round = 0; round < 100; ++round) {
        const Grid grid{2 + round % 30, 5};
        const Points x = Real(0.5) * test::random_cloth(grid, random);
        const Aabb box = Aabb::fit(whole(x, grid));
        const KDop<6> dop = KDop<6>::fit(whole(x, grid));
        for (int b = 0; b < 1000; ++b) {
            const Ball ball = random_ball(box, random, b % 2 == 0);
            ASSERT_EQ(dop.overlaps(ball), box.overlaps(ball));
            overlapping += box.overlaps(ball);
        }
    }
    EXPECT_GT(overlapping, 50'000);
    EXPECT_LT(overlapping, 99'000);
}

TEST(KDop, WithMoreDirectionsNeverOverlapsWhereOneWithFewerDoesNot) {
    std::mt19937 random(32);
    std::array<int, 4> overlaps{};
    for (int round = 0; round < 100; ++round) {
        const Grid grid{2 + round % 30, 5};
        const Points x = Real(0.5) * test::random_cloth(grid, random);
        const Patch patch = whole(x, grid);
        const Aabb box = Aabb::fit(patch);
        for (int b = 0; b < 500; ++b) {
            const Ball ball = random_ball(box, random, false);
            const bool d6 = KDop<6>::fit(patch).overlaps(ball), d14 = KDop<14>::fit(patch).overlaps(ball);
            const bool d18 = KDop<18>::fit(patch).overlaps(ball), d26 = KDop<26>::fit(patch).overlaps(ball);
            ASSERT_LE(d14, d6);
            ASSERT_LE(d18, d6);
            ASSERT_LE(d26, d14);
            ASSERT_LE(d26, d18);
            overlaps[0] += d6, overlaps[1] += d14, overlaps[2] += d18, overlaps[3] += d26;
        }
    }
    EXPECT_GT(overlaps[0], overlaps[1]);
    EXPECT_GT(overlaps[0], overlaps[2]);
    EXPECT_GT(overlaps[1], overlaps[3]);
    EXPECT_GT(overlaps[2], overlaps[3]);
}

/// Along each direction the ball is moved to just touch the slab's face, and then away from it.
template <int K>
void check_faces() {
    std::mt19937 random(33);
    const Grid grid{9, 7};
    const Points x = test::random_cloth(grid, random);
    const KDop<K> dop = KDop<K>::fit(whole(x, grid));
    for (const int number : dop_numbers<K>) {
        const auto& axis = dop_axes[static_cast<std::size_t>(number)];
        for (const int side : {-1, 1}) {
            const Vec3 direction = Vec3(axis[0], axis[1], axis[2]).normalized() * side;
            Eigen::Index p = 0;
            (x * direction).maxCoeff(&p);
            const Vec3 centre = x.row(p).transpose() + Real(0.5) * direction;
            EXPECT_TRUE(dop.overlaps({.centre = centre, .radius = 0.5}));
            EXPECT_FALSE(dop.overlaps({.centre = centre, .radius = 0.5 - 1e-12})) << K << ", direction " << number;
        }
    }
}

TEST(KDop, OverlapsABallThatTouchesAFaceAndNoBallBeyond) {
    check_faces<6>();
    check_faces<14>();
    check_faces<18>();
    check_faces<26>();
}

TEST(KDop, ProjectsAsItsDirectionsSay) {
    std::mt19937 random(34);
    const Grid grid{11, 6};
    const Points x = test::random_cloth(grid, random);
    const KDop<26> dop = KDop<26>::fit(whole(x, grid));
    for (std::size_t k = 0; k < KDop<26>::cuts; ++k) {
        const auto& axis = dop_axes[k + 3];
        const Eigen::VectorXd projections = x * Vec3(axis[0], axis[1], axis[2]);
        EXPECT_NEAR(dop.low[k], projections.minCoeff(), 1e-14);
        EXPECT_NEAR(dop.high[k], projections.maxCoeff(), 1e-14);
    }
}

/// The planted faults: the last direction is not fitted, or has the wrong sign.
TEST(KDop, IsCaughtIfADirectionIsMissing) {
    std::mt19937 random(35);
    int missed = 0, mirrored = 0;
    for (int round = 0; round < 100; ++round) {
        const Grid grid{2 + round % 20, 5};
        const Points x = test::random_cloth(grid, random);
        const KDop<18> dop = KDop<18>::fit(whole(x, grid));
        EXPECT_LE(test::farthest_out(dop, whole(x, grid)), 0);
        KDop<18> without = dop;
        without.low.back() = without.high.back() = 0;
        missed += test::farthest_out(without, whole(x, grid)) > 0;
        KDop<18> wrong = dop;
        wrong.low.back() = -dop.high.back();
        wrong.high.back() = -dop.low.back();
        mirrored += test::farthest_out(wrong, whole(x, grid)) > 0;
    }
    EXPECT_EQ(missed, 100);
    EXPECT_EQ(mirrored, 100);
}

}  // namespace
}  // namespace drape
