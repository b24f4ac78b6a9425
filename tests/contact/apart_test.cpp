// Features that are called apart are apart, and most that are far apart are called so.

#include "contact/pairs/apart.h"

#include <gtest/gtest.h>

#include <random>

#include "drape/contact/closest_point.h"

namespace drape {
namespace {

/// Four points of features that are about as large as they are far from each other, among them needles, flat ones and
/// single points; at some place in space.
std::array<Vec3, 4> features_at_random(std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    const auto point = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    std::array<Vec3, 4> p{point(), point(), point(), point()};
    const Vec3 place = random() % 4 == 0 ? Vec3(1000 * point()) : Vec3::Zero();
    if (random() % 8 == 0) p[1] = p[0];
    if (random() % 8 == 0) p[3] = p[2] + Real(1e-6) * point();
    if (random() % 8 == 0) p[3] = p[2] + p[1] - p[0];
    if (random() % 4 == 0)
        for (Vec3& q : p) q.y() *= Real(1e-9);
    for (Vec3& q : p) q += place;
    return p;
}

/// @param tells of four points and a distance
/// @param measure of four points, the distance
template <class Tells, class Measure>
void hold_against_distance(Tells tells, Measure measure) {
    std::mt19937 random(12);
    std::uniform_real_distribution<Real> part(0, 2);
    int apart = 0, told = 0;
    for (int trial = 0; trial < 200000; ++trial) {
        const std::array<Vec3, 4> p = features_at_random(random);
        const Real distance = measure(p);
        const Real reach = trial % 3 == 0 ? distance : part(random) * distance;
        const bool tells_apart = tells(p, with_rounding(reach));
        if (tells_apart) {
            ASSERT_GT(distance, reach) << trial;
        }
        if (distance > Real(1.2) * reach) ++apart, told += tells_apart ? 1 : 0;
    }
    EXPECT_GT(apart, 10000);
    EXPECT_GT(told, apart / 2) << "of " << apart;
}

TEST(SegmentsAreApart, OnlyIfTheyAre) {
    hold_against_distance([](const auto& p, Real reach) { return segments_are_apart(p[0], p[1], p[2], p[3], reach); },
                          [](const auto& p) { return closest_of_segments(p[0], p[1], p[2], p[3]).offset.norm(); });
}

TEST(TriangleIsApart, OnlyIfItIs) {
    hold_against_distance(
        [](const auto& p, Real reach) { return triangle_is_apart(p[0], p[1], p[2], p[3], reach); },
        [](const auto& p) { return (closest_point_on_triangle(p[0], p[1], p[2], p[3]).point - p[0]).norm(); });
}

}  // namespace
}  // namespace drape
