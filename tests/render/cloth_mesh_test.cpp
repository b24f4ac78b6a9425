#include "render/cloth_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "resting_cloth.h"

namespace drape {
namespace {

using test::RestingCloth;

TEST(ClothMesh, HasPlacesBetweenTheLastTwoStatesNormalsOnTheFrontAndMarks) {
    ClothParameters pinned, upright;
    pinned.pinned.kind = Pins::Kind::Two;
    upright.plane = Plane::XY;
    RestingCloth cloth({6, 5}, pinned);
    cloth.x.col(1).array() += 1;
    cloth.view.grabbed = 7;
    std::vector<ClothVertex> vertices(30);
    fill_cloth_vertices(cloth.view, 0, Real(0.25), vertices.data());
    for (int p = 0; p < 30; ++p) {
        const ClothVertex& vertex = vertices[static_cast<std::size_t>(p)];
        EXPECT_FLOAT_EQ(vertex.position[1], 0.25f);
        EXPECT_FLOAT_EQ(vertex.normal[1], 1);
        EXPECT_EQ(vertex.pinned, p == 0 || p == 5 ? 1 : p == 7 ? 2 : 0);
    }
    fill_cloth_vertices(RestingCloth({6, 5}, upright).view, 0, 1, vertices.data());
    for (const ClothVertex& vertex : vertices) EXPECT_FLOAT_EQ(vertex.normal[2], 1);
    cloth.x.setZero();
    fill_cloth_vertices(cloth.view, 0, 1, vertices.data());
    for (const ClothVertex& vertex : vertices) EXPECT_FLOAT_EQ(vertex.normal[1], 1) << "all particles meet";
}

/// Waves along x, seen from above: hollow in the valleys, the contrary on the crests, nothing in between.
TEST(ClothMesh, IsHollowInTheFoldsOfItsFront) {
    RestingCloth cloth({41, 5});
    for (int p = 0; p < 205; ++p) cloth.x(p, 1) = Real(0.05) * std::cos(2 * std::numbers::pi_v<Real> * (p % 41) / 20);
    std::vector<ClothVertex> vertices(205);
    fill_cloth_vertices(cloth.view, 0, 1, vertices.data());
    const auto hollow = [&](int i) { return vertices[static_cast<std::size_t>(2 * 41 + i)].hollow; };
    EXPECT_GT(hollow(10), 0.2f);
    EXPECT_LT(hollow(20), -0.2f);
    EXPECT_NEAR(hollow(15), 0, 0.02f);
    cloth.x.col(1).setZero();
    fill_cloth_vertices(cloth.view, 0, 1, vertices.data());
    for (const ClothVertex& vertex : vertices) EXPECT_NEAR(vertex.hollow, 0, 1e-3f);
}

/// Laid out flat; the last corner of both triangles of a cell is its corner b.
TEST(ClothMesh, HasPlacesInMetresAndTrianglesThatEndAtCornerB) {
    ClothParameters wide;
    wide.width = 2;
    const RestingCloth cloth({6, 5}, wide);
    std::vector<ClothVertex> vertices(30);
    fill_cloth_vertices(cloth.view, 3, 1, vertices.data());
    EXPECT_EQ(vertices[0].place, (std::array<float, 4>{0, 0, 2, 1}));
    EXPECT_EQ(vertices[0].number, 3);
    EXPECT_FLOAT_EQ(vertices[13].place[0], 0.4f);
    EXPECT_FLOAT_EQ(vertices[13].place[1], 0.5f);

    const Grid& grid = cloth.model.grid;
    const std::vector<std::uint32_t> indices = triangle_indices({&grid, 1});
    for (std::size_t t = 0; 3 * t < indices.size(); ++t) {
        const auto cell = static_cast<int>(t / 2);
        EXPECT_EQ(indices[3 * t + 2], static_cast<std::uint32_t>(grid.cell_corner(cell) + 1));
        std::array<int, 3> corners = grid.triangle_corners(static_cast<int>(t));
        std::array<int, 3> drawn;
        for (std::size_t k = 0; k < 3; ++k) drawn[k] = static_cast<int>(indices[3 * t + k]);
        while (drawn[0] != corners[0]) std::rotate(drawn.begin(), drawn.begin() + 1, drawn.end());
        EXPECT_EQ(drawn, corners) << "the same side is the front";
    }
}

TEST(ClothMesh, HasTrianglesOfItsOwnForEachCloth) {
    const std::vector<Grid> grids{{6, 5}, {6, 5}};
    const std::vector<std::uint32_t> one = triangle_indices(std::span(grids).first(1)), two = triangle_indices(grids);
    ASSERT_EQ(two.size(), 2 * one.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(two[one.size() + i], 30 + one[i]);
}

TEST(ClothMesh, HasEverySpringOfEachClothOnce) {
    const std::vector<Grid> grids{{6, 5}, {6, 5}};
    const SpringIndices springs = spring_indices(grids);
    EXPECT_EQ(springs.counts, (std::array{2 * (5 * 5 + 6 * 4), 2 * (2 * 5 * 4), 2 * (4 * 5 + 6 * 3)}));
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < springs.ends.size(); i += 2) {
        EXPECT_TRUE(pairs.insert(std::minmax(springs.ends[i], springs.ends[i + 1])).second);
        EXPECT_EQ(springs.ends[i] / 30, springs.ends[i + 1] / 30);
        EXPECT_LT(springs.ends[i], 60u);
    }
}

}  // namespace
}  // namespace drape
