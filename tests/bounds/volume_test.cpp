// What every volume must do, whatever its shape.

#include <gtest/gtest.h>

#include "drape/bounds/cloth_quadtree.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

using test::farthest_out;
using test::whole;

template <class V>
class Volume : public ::testing::Test {};

TYPED_TEST_SUITE(Volume, test::UnlikeVolumes, test::VolumeNames);

/// Patches of any shape, at several scales, at the origin and far from it: a cloth of 1 m at 1000 m, and so on.
template <class Visit>
void for_many_patches(Visit visit) {
    std::mt19937 random(11);
    for (const Real scale : {1e-6, 1.0, 1e6}) {
        for (const Real away : {0.0, 1000.0}) {
            for (int columns = 2; columns <= 40; ++columns) {
                const Grid grid{columns, 2 + columns % 7};
                Points x = test::random_cloth(grid, random);
                x.rowwise() += away * Eigen::Matrix<Real, 1, 3>(1, -1, Real(0.7));
                visit(grid, Points(scale * x));
            }
        }
    }
}

TYPED_TEST(Volume, AndItsSphereContainItsParticlesAtAnyScaleAndFarOut) {
    for_many_patches([](const Grid& grid, const Points& x) {
        for (const Kernels kernels : {Kernels::Vector, Kernels::Plain}) {
            const TypeParam volume = fits_of<TypeParam>({.kernels = kernels}).patch(whole(x, grid));
            ASSERT_LE(farthest_out(volume, whole(x, grid)), 0) << grid.nx << " columns";
            ASSERT_LE(farthest_out(volume.sphere(), whole(x, grid)), 0) << grid.nx << " columns";
        }
    });
}

/// As far as the farthest of its faces, seen from the ball's centre.
TYPED_TEST(Volume, LeavesOutABallThatEndsBeforeAFace) {
    std::mt19937 random(13);
    std::normal_distribution<Real> normal;
    const Grid grid{9, 7};
    for (int round = 0; round < 500; ++round) {
        const TypeParam volume = TypeParam::fit(whole(test::random_cloth(grid, random), grid));
        const Vec3 centre = 2 * Vec3(normal(random), normal(random), normal(random));
        const auto gap = static_cast<Real>(test::stands_out(volume, centre));
        if (gap > 0) {
            EXPECT_FALSE(volume.overlaps({.centre = centre, .radius = gap - Real(1e-12)})) << round;
        }
    }
}

}  // namespace
}  // namespace drape
