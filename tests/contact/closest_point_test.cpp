#include "drape/contact/closest_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <random>

#include "drape/contact/detection.h"
#include "support/cloths.h"
#include "support/exact_distance.h"

namespace drape {
namespace {

TEST(ClosestPoint, IsTheNearestOfTheTriangle) {
    std::mt19937 random(9);
    std::uniform_real_distribution<Real> unit(-1, 1);
    const auto point = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    for (int round = 0; round < 200'000; ++round) {
        const Vec3 p = 2 * point(), a = point(), b = point(), c = point();
        const ClosestPoint closest = closest_point_on_triangle(p, a, b, c);
        const auto& w = closest.barycentric;
        ASSERT_NEAR((closest.point - p).norm(), distance_to_triangle(p, a, b, c), 1e-12);
        ASSERT_LT((w[0] * a + w[1] * b + w[2] * c - closest.point).norm(), 1e-12);
        ASSERT_TRUE(w[0] >= -1e-15 && w[1] >= -1e-15 && w[2] >= -1e-15 && std::abs(w[0] + w[1] + w[2] - 1) < 1e-14);
    }
}

TEST(ClosestPoint, ExistsOnTrianglesWithoutArea) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), p(0.25, 1, 0);
    EXPECT_TRUE(closest_point_on_triangle(p, a, a, a).point.isApprox(a));
    for (const auto& corners : {std::array{a, b, b}, std::array{b, a, b}, std::array{a, a, b},
                                std::array{a, Vec3(0.5, 0, 0), b}, std::array{b, a, Vec3(0.5, 0, 0)}}) {
        const ClosestPoint closest = closest_point_on_triangle(p, corners[0], corners[1], corners[2]);
        EXPECT_TRUE(closest.point.isApprox(Vec3(0.25, 0, 0))) << closest.point.transpose();
        const auto& w = closest.barycentric;
        EXPECT_TRUE((w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2]).isApprox(closest.point));
    }
}

TEST(ClosestPoint, IsTheNearestOfNeedlesToo) {
    std::mt19937 random(11);
    std::uniform_real_distribution<Real> unit(-1, 1);
    const auto point = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    for (const Real width : {0.0, 1e-16, 1e-15, 1e-14, 1e-12, 1e-9, 1e-6}) {
        for (int round = 0; round < 3000; ++round) {
            const Vec3 a = point(), b = point(), p = 2 * point();
            const Vec3 c = a + unit(random) * 2 * (b - a) + width * point();
            const Real by_edges =
                std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
            ASSERT_NEAR((closest_point_on_triangle(p, a, b, c).point - p).norm(), by_edges, 1e-12 + width) << width;
        }
    }
}

TEST(TouchedTriangles, AreThoseWithinTheRadius) {
    std::mt19937 random(10);
    std::uniform_real_distribution<Real> unit(-1, 1);
    const Grid grid{14, 9};
    std::vector<CellRun> all;
    list_all_cells(grid, all);
    std::vector<int> touched;
    long found = 0;
    for (int round = 0; round < 5000; ++round) {
        const Points x = test::random_cloth(grid, random);
        const Ball ball{.centre = 0.6 * Vec3(unit(random), unit(random), unit(random)),
                        .radius = 0.2 + 0.19 * unit(random)};
        find_touched_triangles(grid, x, ball, 0.002, all, touched, Kernels::Vector);
        std::size_t next = 0;
        for (int t = 0; t < grid.triangles(); ++t) {
            const auto [a, b, c] = grid.triangle_corners(t);
            const Real distance =
                distance_to_triangle(ball.centre, x.row(a).transpose(), x.row(b).transpose(), x.row(c).transpose());
            const bool listed = next < touched.size() && touched[next] == t;
            const bool undecided = std::abs(distance - ball.radius - 0.002) < 1e-12;
            ASSERT_TRUE(undecided || listed == (distance <= ball.radius + 0.002));
            if (!listed) continue;
            ++next;
        }
        ASSERT_EQ(next, touched.size());
        found += static_cast<long>(next);
    }
    EXPECT_GT(found, 10'000);
}

}  // namespace
}  // namespace drape
