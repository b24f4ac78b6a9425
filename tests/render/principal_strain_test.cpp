#include "render/principal_strain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "resting_cloth.h"

namespace drape {
namespace {

/// A sheet of oblong cells, stretched by 4 % along a direction in its plane and compressed by 2 % across it.
TEST(PrincipalStrain, OfAStretchedSheetHasTheStretchAndItsDirection) {
    test::RestingCloth cloth({41, 24});
    const Vec3 along(std::cos(Real(0.5)), 0, std::sin(Real(0.5))), across(-along.z(), 0, along.x());
    const Points& rest = cloth.previous;
    cloth.x += Real(0.04) * rest * along * along.transpose() - Real(0.02) * rest * across * across.transpose();
    const PrincipalStrain cell = principal_strain(cloth.view, 1, 7, 3);
    EXPECT_NEAR(cell.strains[0], -0.02, 1e-9);
    EXPECT_NEAR(cell.strains[1], 0.04, 1e-9);
    EXPECT_NEAR(std::abs(cell.directions[1].dot(along)), 1, 1e-9);
    EXPECT_NEAR(std::abs(cell.directions[0].dot(across)), 1, 1e-9);

    Settings settings;
    FrameView view;
    view.cloths = {&cloth.view, 1};
    settings.view.colour = ColourBy::PrincipalStrain;
    view.settings = &settings;
    const auto [edges, full] = strain_crosses(view);
    EXPECT_EQ(full, 5) << "%";
    EXPECT_EQ(edges.size(), 2 * 13 * 8) << "a cross for 3 x 3 cells";
    EXPECT_EQ(edges[0].from.state, NodeState::Compressed);
    EXPECT_EQ(edges[1].from.state, NodeState::Stretched);
    const float length = (edges[1].to.point - edges[1].from.point).norm();
    EXPECT_NEAR(length, 0.9 * 3 * std::min(cloth.model.hx, cloth.model.hy) * 0.8, 1e-6);
}

}  // namespace
}  // namespace drape
