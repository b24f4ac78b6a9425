#include "render/smooth_outline.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace drape {
namespace {

class SmoothOutlineTest : public testing::Test {
protected:
    /// A cloth about a tube of radius 1 along its columns, of this many degrees from particle to particle.
    /// @param bulge by how much the radius differs from row to row
    void roll(const Grid& grid, double degrees, double bulge = 0) {
        grid_ = grid;
        vertices_.assign(4 * static_cast<std::size_t>(grid.particles()), {});
        for (int p = 0; p < grid.particles(); ++p) {
            const double angle = degrees * std::numbers::pi / 180 * (p % grid.nx);
            ClothVertex& vertex = vertices_[static_cast<std::size_t>(p)];
            vertex.normal = Eigen::Vector3d(std::sin(angle), std::cos(angle), 0).cast<float>();
            vertex.position = static_cast<float>(1 + bulge * std::sin(1 + p / grid.nx)) * vertex.normal;
            vertex.position.z() = 0.1f * static_cast<float>(p / grid.nx);
            vertex.value = static_cast<float>(p);
            vertex.pinned = 1;
            vertex.place = {static_cast<float>(p), 1, 2, 3};
            vertex.number = 5;
        }
    }

    const std::vector<std::uint32_t>& fill(const Eigen::Vector3f& eye, float pixels = 1000) {
        const auto count = static_cast<std::size_t>(grid_.particles());
        indices_.assign(12 * static_cast<std::size_t>(grid_.triangles()), 0);
        in_buffer_ = {vertices_.data(), vertices_.data() + count, 0, static_cast<std::uint32_t>(count)};
        const std::uint32_t* end = outline_.fill(grid_, in_buffer_, {eye, pixels}, indices_.data());
        indices_.resize(static_cast<std::size_t>(end - indices_.data()));
        return indices_;
    }

    [[nodiscard]] const Eigen::Vector3f& at(std::uint32_t vertex) const { return vertices_[vertex].position; }

    /// How often each edge is used, by the way in which its triangle goes round.
    [[nodiscard]] std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses() const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
        for (std::size_t t = 0; t < indices_.size(); t += 3) {
            for (std::size_t k = 0; k < 3; ++k) ++uses[{indices_[t + k], indices_[t + (k + 1) % 3]}];
        }
        return uses;
    }

    Grid grid_;
    std::vector<ClothVertex> vertices_;
    SmoothOutline::Vertices in_buffer_{};
    std::vector<std::uint32_t> indices_;
    SmoothOutline outline_;
};

// Far along x: the outline of the tube is where it faces up and down
const Eigen::Vector3f beside(50, 0, 0.2f);

/// Through its particles, a tube is drawn as a polygon; the middles of its edges are ten times as near to it, where the
/// outline is.
TEST_F(SmoothOutlineTest, IsRoundWhereThePolygonHasCornersAndLeavesTheParticlesWhereTheyAre) {
    roll({18, 4}, 20);
    const std::vector<ClothVertex> before = vertices_;
    fill(beside, 1e6f);
    for (std::size_t p = 0; p < 72; ++p) {
        EXPECT_EQ(vertices_[p].position, before[p].position);
        EXPECT_EQ(vertices_[p].pinned, 1);
    }
    const double polygon = 1 - std::cos(10 * std::numbers::pi / 180);
    int on_outline = 0;
    for (const std::uint32_t index : indices_) {
        const Eigen::Vector3f p = at(index);
        if (index < 72 || std::abs(p.x()) > 0.2f || p.y() > 0) continue;
        ++on_outline;
        EXPECT_LT(std::abs(p.head<2>().norm() - 1), polygon / 10);
    }
    EXPECT_GT(on_outline, 0);
    // Colours and normals are between those of the particles, here at the lowest line
    const ClothVertex &a = vertices_[9], &b = vertices_[10], &middle = vertices_[72 + 3 * 9];
    EXPECT_EQ(middle.value, 9.5f);
    EXPECT_EQ(middle.pinned, 0);
    EXPECT_EQ(middle.place, (std::array{9.5f, 1.0f, 2.0f, 3.0f}));
    EXPECT_EQ(middle.number, 5);
    EXPECT_LT((middle.normal - (a.normal + b.normal) / 2).norm(), 1e-6f);
}

TEST_F(SmoothOutlineTest, HasNoGapsAndKeepsItsFront) {
    for (const Eigen::Vector3f& eye : {beside, Eigen::Vector3f(3, 1, 2), Eigen::Vector3f(-0.5f, 2, 0.3f)}) {
        roll({11, 7}, 17, 0.05);
        fill(eye, 1e6f);
        EXPECT_GT(indices_.size(), 3 * static_cast<std::size_t>(grid_.triangles())) << "something is divided";
        const auto all = uses();
        int borders = 0;
        for (const auto& [edge, count] : all) {
            EXPECT_EQ(count, 1);
            if (!all.contains({edge.second, edge.first})) ++borders;
        }
        EXPECT_EQ(borders, 4 * (grid_.nx - 1) + 4 * (grid_.ny - 1)) << "each edge of the border is divided";

        std::vector<std::uint32_t> hem(2 * static_cast<std::size_t>(borders));
        EXPECT_EQ(outline_.fill_hem(grid_, in_buffer_, hem.data() + hem.size()), hem.data());
        std::set<std::pair<std::uint32_t, std::uint32_t>> lines;
        for (std::size_t k = 0; k < hem.size(); k += 2) {
            EXPECT_TRUE(lines.insert(std::minmax(hem[k], hem[k + 1])).second) << "each once";
            EXPECT_NE(all.contains({hem[k], hem[k + 1]}), all.contains({hem[k + 1], hem[k]})) << "only on the border";
        }
        for (std::size_t t = 0; t < indices_.size(); t += 3) {
            const Eigen::Vector3f a = at(indices_[t]), b = at(indices_[t + 1]), c = at(indices_[t + 2]);
            const Eigen::Vector3f out((a + b + c).x(), (a + b + c).y(), 0);
            EXPECT_GT((b - a).cross(c - a).dot(out), 0);
        }
    }
}

TEST_F(SmoothOutlineTest, DrawsTheTrianglesAsTheyAreWhereTheyFaceTheEye) {
    roll({5, 4}, 2);
    for (std::size_t p = 0; p < 20; ++p) {  // flat, with borders that are straight
        vertices_[p].position.head<2>() << 0.1f * static_cast<float>(p % 5), 1;
    }
    EXPECT_EQ(fill({0, 50, 0}), triangle_indices({&grid_, 1}));
}

/// Sizes on the screen decide: far away nothing is divided.
TEST_F(SmoothOutlineTest, DividesNothingThatIsTooSmallToBeSeen) {
    roll({12, 5}, 20);
    EXPECT_EQ(fill(beside, 100), triangle_indices({&grid_, 1}));
    EXPECT_EQ(outline_.farthest(), 0);
    fill(beside, 1e5f);
    EXPECT_NEAR(outline_.farthest(), (1 - std::cos(10 * std::numbers::pi / 180)) * 1e5 / 50, 3);
    roll({2, 2}, 10);
    EXPECT_EQ(fill(beside, 1e6f), triangle_indices({&grid_, 1})) << "lines through two particles are straight";
}

}  // namespace
}  // namespace drape
