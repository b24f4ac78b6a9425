#include "render/cloth_mesh.h"

#include <gtest/gtest.h>

#include <set>

namespace drape {
namespace {

struct FlatCloth {
    explicit FlatCloth(Plane plane) {
        ClothParameters parameters;
        parameters.particles = {6, 5};
        parameters.plane = plane;
        parameters.pinned.kind = Pins::Kind::Two;
        model = make_cloth_model(parameters);
        x = previous = make_rest_state(parameters).x;
    }

    [[nodiscard]] ClothView view() const { return {model, x, previous, {}, nullptr}; }

    ClothModel model;
    Points x, previous;
};

TEST(ClothMesh, HasNormalsOnTheFront) {
    std::vector<ClothVertex> vertices(30);
    fill_cloth_vertices(FlatCloth(Plane::XZ).view(), 1, vertices.data());
    for (const ClothVertex& vertex : vertices) EXPECT_FLOAT_EQ(vertex.normal[1], 1);
    fill_cloth_vertices(FlatCloth(Plane::XY).view(), 1, vertices.data());
    for (const ClothVertex& vertex : vertices) EXPECT_FLOAT_EQ(vertex.normal[2], 1);
}

TEST(ClothMesh, LiesBetweenTheLastTwoStates) {
    FlatCloth cloth(Plane::XZ);
    cloth.x.col(1).array() += 1;
    std::vector<ClothVertex> vertices(30);
    fill_cloth_vertices(cloth.view(), Real(0.25), vertices.data());
    for (const ClothVertex& vertex : vertices) EXPECT_FLOAT_EQ(vertex.position[1], 0.25f);
}

TEST(ClothMesh, MarksPinnedParticles) {
    std::vector<ClothVertex> vertices(30);
    fill_cloth_vertices(FlatCloth(Plane::XZ).view(), 1, vertices.data());
    for (int p = 0; p < 30; ++p) EXPECT_EQ(vertices[static_cast<std::size_t>(p)].pinned, p == 0 || p == 5 ? 1 : 0);
}

TEST(ClothMesh, HasNoNormalThatIsNoneWhereAllParticlesMeet) {
    FlatCloth cloth(Plane::XZ);
    cloth.x.setZero();
    cloth.previous = cloth.x;
    std::vector<ClothVertex> vertices(30);
    fill_cloth_vertices(cloth.view(), 1, vertices.data());
    for (const ClothVertex& vertex : vertices) EXPECT_FLOAT_EQ(vertex.normal[1], 1);
}

TEST(ClothMesh, HasEverySpringOfEachClothOnce) {
    const std::vector<Grid> grids{{6, 5}, {6, 5}};
    const SpringIndices springs = spring_indices(grids);
    EXPECT_EQ(springs.structural.size(), 4u * (5 * 5 + 6 * 4));
    EXPECT_EQ(springs.shear.size(), 4u * (2 * 5 * 4));
    EXPECT_EQ(springs.bend.size(), 4u * (4 * 5 + 6 * 3));
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const auto* kind : {&springs.structural, &springs.shear, &springs.bend}) {
        for (std::size_t i = 0; i < kind->size(); i += 2) {
            EXPECT_TRUE(pairs.insert(std::minmax((*kind)[i], (*kind)[i + 1])).second);
            EXPECT_EQ((*kind)[i] / 30, (*kind)[i + 1] / 30);
            EXPECT_LT((*kind)[i], 60u);
        }
    }
}

}  // namespace
}  // namespace drape
