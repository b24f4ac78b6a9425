#include "drape/bounds/obb.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "drape/bounds/aabb.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

using test::whole;

void expect_orthonormal(const BoxAxes& axes) {
    EXPECT_LT((axes.transpose() * axes - BoxAxes::Identity()).cwiseAbs().maxCoeff(), 1e-14) << axes;
}

/// A sheet of 1 m by 2 m, turned and moved.
Points turned_sheet(const Grid& grid, const Eigen::Quaterniond& turn, const Vec3& away) {
    Points x(grid.particles(), 3);
    for (int p = 0; p < grid.particles(); ++p) {
        const Vec3 flat(static_cast<Real>(p % grid.nx) / (grid.nx - 1), 0,
                        2 * static_cast<Real>(p / grid.nx) / (grid.ny - 1));
        x.row(p) = (turn * flat + away).transpose();
    }
    return x;
}

TEST(Obb, LiesFlatOnAFlatSheetHoweverItIsTurned) {
    const Grid grid{7, 5};
    std::mt19937 random(41);
    std::normal_distribution<Real> normal;
    for (int round = 0; round < 100; ++round) {
        Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
        turn.normalize();
        const Points x = turned_sheet(grid, turn, round % 2 == 0 ? Vec3(0, 0, 0) : Vec3(1000, -1000, 1000));
        const Obb box = Obb::fit(whole(x, grid));
        expect_orthonormal(box.axes);
        EXPECT_TRUE((box.high - box.low).isApprox(Vec3(1, 2, 0), 1e-11)) << (box.high - box.low).transpose();
    }
}

TEST(Obb, HasAnOrthonormalFrameWhateverTheCloth) {
    const Grid grid{4, 3};
    const Vec3 ways[] = {Vec3::Zero(),  Vec3(1, 0, 0),           Vec3(0, 0, -1),
                         Vec3(1, 1, 1), Vec3(1e-200, 0, 1e-200), Vec3(1, 1e-9, 0)};
    for (const Vec3& along : ways) {
        for (const Vec3& across : ways) {
            Points x(12, 3);
            for (int p = 0; p < 12; ++p) x.row(p) = (along * (p % 4) + across * (p / 4)).transpose();
            const Obb box = Obb::fit(whole(x, grid));
            expect_orthonormal(box.axes);
            expect_orthonormal(Obb::merge(std::array{box, box}).axes);
            EXPECT_LE(test::farthest_out(box, whole(x, grid)), 0);
        }
    }
}

/// @param origin, axes what the corners of the box are seen from
template <class Box>
void expect_overlap(const Box& box, const Vec3& origin, const BoxAxes& axes) {
    for (const Vec3& off : {Vec3(0.5, 0, 0), Vec3(0, -0.5, 0), Vec3(0.3, 0.4, 0), Vec3(-0.2, -0.3, 0.6)}) {
        Vec3 corner;
        for (int k = 0; k < 3; ++k) corner[k] = off[k] > 0 ? box.high[k] : box.low[k];
        const Vec3 centre = origin + axes * (corner + off);
        const Real rounding = 1e-15 * (1 + centre.norm());
        EXPECT_TRUE(box.overlaps({.centre = centre, .radius = off.norm() + rounding}));
        EXPECT_FALSE(box.overlaps({.centre = centre, .radius = off.norm() - rounding - 1e-12}));
    }
    EXPECT_TRUE(box.overlaps({.centre = origin + axes * (box.low + box.high) / 2, .radius = 0}));
}

TEST(Boxes, OverlapABallThatTouchesAFaceAnEdgeOrACornerAndNoBallBeyond) {
    expect_overlap(Aabb{Vec3(0, 0, 0), Vec3(1, 2, 3)}, Vec3::Zero(), BoxAxes::Identity());
    const Grid grid{7, 5};
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
    for (const Vec3& away : {Vec3(0, 0, 0), Vec3(1000, -1000, 1000)}) {
        const Obb box = Obb::fit(whole(turned_sheet(grid, turn, away), grid));
        expect_overlap(box, box.origin, box.axes);
    }
}

TEST(Obb, MergedFromBoxesTurnedTheOtherWayRoundStaysFlat) {
    const Grid grid{7, 5};
    const Points x =
        turned_sheet(grid, Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), Vec3(1, 2, 3));
    Obb there = Obb::fit(whole(x, grid)), back = there;
    back.axes.col(0) *= -1;
    back.axes.col(1) *= -1;
    for (int k = 0; k < 2; ++k) std::swap(back.low[k], back.high[k]), back.low[k] *= -1, back.high[k] *= -1;
    const Obb both = Obb::merge(std::array{there, back});
    EXPECT_TRUE((both.high - both.low).isApprox(Vec3(1, 2, 0), 1e-11)) << (both.high - both.low).transpose();
}

}  // namespace
}  // namespace drape
