#include <gtest/gtest.h>

#include <random>

#include "drape/contact/detection.h"
#include "support/cloths.h"
#include "support/exact_distance.h"

namespace drape {
namespace {

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
