#include "drape/bounds/kdop.h"

#include <gtest/gtest.h>

#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

using test::whole;

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

}  // namespace
}  // namespace drape
