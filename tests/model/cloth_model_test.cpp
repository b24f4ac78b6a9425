#include "drape/model/cloth_model.h"

#include <gtest/gtest.h>

#include <set>

namespace drape {
namespace {

std::set<int> pinned_particles(const Pins& pins, Grid grid) {
    ClothParameters parameters;
    parameters.particles = grid;
    parameters.pinned = pins;
    const ClothModel model = make_cloth_model(parameters);
    std::set<int> found;
    for (int p = 0; p < grid.particles(); ++p) {
        if (model.pinned(p)) found.insert(p);
    }
    return found;
}

TEST(Grid, NumbersTrianglesAsTheDesignSays) {
    const Grid grid{4, 3};
    EXPECT_EQ(grid.triangles(), 12);
    EXPECT_EQ(grid.triangle_corners(0), (std::array{0, 4, 1}));  // a, c, b
    EXPECT_EQ(grid.triangle_corners(1), (std::array{1, 4, 5}));  // b, c, d
    EXPECT_EQ(grid.triangle_corners(8), (std::array{5, 9, 6}));  // cell (1, 1)
    EXPECT_EQ(grid.triangle_corners(11), (std::array{7, 10, 11}));
}

TEST(ClothModel, SharesTheMassAmongAllParticlesPinnedOnesCounted) {
    ClothParameters parameters;
    parameters.particles = {5, 4};
    parameters.mass = 2;
    parameters.pinned.kind = Pins::Kind::Border;
    EXPECT_DOUBLE_EQ(make_cloth_model(parameters).particle_mass, 0.1);
}

TEST(ClothModel, PinsByName) {
    EXPECT_EQ(pinned_particles({Pins::Kind::None, {}}, {4, 3}), (std::set<int>{}));
    EXPECT_EQ(pinned_particles({Pins::Kind::Two, {}}, {4, 3}), (std::set{0, 3}));
    EXPECT_EQ(pinned_particles({Pins::Kind::Four, {}}, {4, 3}), (std::set{0, 3, 8, 11}));
    EXPECT_EQ(pinned_particles({Pins::Kind::Row, {}}, {4, 3}), (std::set{0, 1, 2, 3}));
    EXPECT_EQ(pinned_particles({Pins::Kind::Border, {}}, {4, 3}), (std::set{0, 1, 2, 3, 4, 7, 8, 9, 10, 11}));
    EXPECT_EQ(pinned_particles({Pins::Kind::List, {5, 6, 5}}, {4, 3}), (std::set{5, 6}));
}

TEST(RestState, LiesInItsPlaneFromTheOrigin) {
    ClothParameters parameters;
    parameters.particles = {3, 5};
    parameters.width = 2;
    parameters.height = 8;
    parameters.place = {1, 2, 3};
    const ClothState horizontal = make_rest_state(parameters);
    EXPECT_EQ(horizontal.x.row(0), Eigen::RowVector3d(1, 2, 3));
    EXPECT_EQ(horizontal.x.row(14), Eigen::RowVector3d(3, 2, 11));
    parameters.plane = Plane::XY;
    EXPECT_EQ(make_rest_state(parameters).x.row(14), Eigen::RowVector3d(3, -6, 3));
    EXPECT_TRUE(horizontal.v.isZero());
}

}  // namespace
}  // namespace drape
