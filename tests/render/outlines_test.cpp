#include "render/drawn_nodes.h"

#include <gtest/gtest.h>

#include <set>

#include "drape/bounds/broad_phase.h"
#include "support/cloths.h"
#include "support/containment.h"

namespace drape {
namespace {

using test::whole;

/// A square of side 1 m at rest, in a tree of two levels.
TEST(Outlines, OfALevelShowWhatTheQueryDidAndWhatTouches) {
    const Grid grid{9, 9};
    ClothParameters parameters;
    parameters.particles = grid;
    for (const VolumeKind volume : {VolumeKind::Sphere, VolumeKind::Obb}) {
        const auto tree = make_broad_phase({.volume = volume, .leaf_cells = 4}, grid);
        tree->build(make_rest_state(parameters).x);
        Candidates found;
        tree->query({.centre = Vec3(0, 0, 0), .radius = Real(0.05)}, found);
        std::vector<NodeView> nodes;
        tree->nodes_at(1, nodes);
        constexpr Real slack = Real(0.5);
        const auto states = [&](std::span<const ContactRow> contacts, bool tested) {
            const TouchedCells touched(grid, contacts, tested);
            Outlines outlines;
            for (const NodeView& node : nodes) append_outline(node.volume, slack, touched.state_of(node), outlines);
            std::set<NodeState> all;
            for (std::size_t s = 0; s < outlines.spheres.size(); ++s) {
                all.insert(outlines.spheres[s].state);
                EXPECT_NEAR(outlines.spheres[s].radius, std::get<BoundingSphere>(nodes[s].volume).radius + slack, 1e-6);
            }
            for (const Outlines::Edge& edge : outlines.edges) all.insert(edge.from.state);
            return all;
        };
        ContactRow first, last;
        first.triangle = 0;
        last.triangle = 2 * grid.cells() - 1;
        EXPECT_EQ(states({}, true), (std::set{NodeState::Pruned, NodeState::FalseLeaf}));
        EXPECT_EQ(states({}, false), (std::set{NodeState::Pruned, NodeState::Untested})) << "nothing is known yet";
        EXPECT_EQ(states({&first, 1}, true), (std::set{NodeState::Pruned, NodeState::Touching}));
        EXPECT_EQ(states({&last, 1}, true), (std::set{NodeState::Pruned, NodeState::FalseLeaf}))
            << "the query has left that one out";
    }
}

/// Ends on the surface; every corner is in three edges or more, but for the rounding; Euler's count of faces.
/// @return the ends of all edges
template <class Volume>
std::vector<Vec3> check_outline(const Volume& volume, std::size_t faces) {
    Outlines outlines;
    append_outline(volume, 0, NodeState::FalseInner, outlines);
    const long double size = volume.sphere().radius;
    EXPECT_GE(outlines.edges.size(), 6u);
    EXPECT_LE(outlines.edges.size(), 3 * faces - 6);
    std::vector<Vec3> ends;
    for (const Outlines::Edge& edge : outlines.edges) {
        const Vec3 from = edge.from.point.cast<Real>(), to = edge.to.point.cast<Real>();
        for (const Vec3& point : {from, to, Vec3((from + to) / 2)}) {
            EXPECT_NEAR(static_cast<double>(test::stands_out(volume, point) / size), 0, 1e-4);
        }
        ends.insert(ends.end(), {from, to});
    }
    for (const Vec3& end : ends) {
        const auto near = [&](const Vec3& other) { return (other - end).norm() < 1e-3 * static_cast<double>(size); };
        EXPECT_GE(std::count_if(ends.begin(), ends.end(), near), 3) << faces;
    }
    return ends;
}

/// The edges reach as far as the faces of the box do.
template <int K>
void check_dop(const Points& x, const Grid& grid) {
    const KDop<K> dop = KDop<K>::fit(whole(x, grid));
    const std::vector<Vec3> ends = check_outline(dop, K);
    for (int k = 0; k < 3; ++k) {
        Real most = -1e9;
        for (const Vec3& end : ends) most = std::max(most, end[k]);
        EXPECT_NEAR(most, dop.box.high[k], 1e-4);
    }
}

TEST(Outlines, OfAVolumeAreTheEdgesOfItsSurface) {
    std::mt19937 random(36);
    for (int round = 0; round < 20; ++round) {
        const Grid grid{4 + round % 20, 6};
        const Points x = test::random_cloth(grid, random);
        check_outline(Aabb::fit(whole(x, grid)), 6);
        check_outline(Obb::fit(whole(x, grid)), 6);
        check_dop<6>(x, grid);
        check_dop<14>(x, grid);
        check_dop<18>(x, grid);
        check_dop<26>(x, grid);
    }
}

/// Above and below; every direction that is cut off by others only touches.
TEST(Outlines, OfAFlatClothHaveEachEdgeTwice) {
    const Grid grid{5, 5};
    Points square(25, 3), diamond(25, 3);
    for (int p = 0; p < 25; ++p) {
        square.row(p) << p % 5, 0, p / 5;
        diamond.row(p) << p % 5 + p / 5, 0, p % 5 - p / 5;
    }
    for (const auto& [x, side] : {std::pair(square, 4.0), std::pair(diamond, std::sqrt(32.0))}) {
        Outlines outlines;
        append_outline(KDop<26>::fit(whole(x, grid)), 0, NodeState::FalseInner, outlines);
        EXPECT_EQ(outlines.edges.size(), 8u);
        for (const auto& [from, to] : outlines.edges) EXPECT_NEAR((to.point - from.point).norm(), side, 1e-3);
    }
}

TEST(Outlines, OfAPointOrALineAreNothingOrTheLine) {
    const Grid grid{3, 3};
    Outlines outlines;
    append_outline(KDop<26>::fit(whole(Points::Constant(9, 3, 0.1), grid)), 0, NodeState::FalseInner, outlines);
    EXPECT_TRUE(outlines.edges.empty());
    Points x = Points::Zero(9, 3);
    for (int p = 0; p < 9; ++p) x(p, 1) = p;
    append_outline(KDop<26>::fit(whole(x, grid)), 0, NodeState::FalseInner, outlines);
    ASSERT_FALSE(outlines.edges.empty());
    for (const auto& [from, to] : outlines.edges) EXPECT_NEAR((to.point - from.point).norm(), 8, 1e-3);
}

}  // namespace
}  // namespace drape
