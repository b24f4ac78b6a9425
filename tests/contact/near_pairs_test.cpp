// Pairs of features that are near each other, by hierarchies and by brute force. Those within one cloth are in
// folded_pairs_test.cpp.

#include "drape/contact/near_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drape/contact/closest_point.h"
#include "searched_cloth.h"
#include "support/cloths.h"
#include "support/exact_distance.h"

namespace drape {
namespace {

using test::pairs_within;
using test::SearchedCloth;

/// A cloth that is squeezed along two axes, so that it comes near itself in many ways.
Points squeezed_cloth(const Grid& grid, std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(0, 1);
    Points x = test::random_cloth(grid, random);
    x.col(0) *= Real(0.02) + unit(random);
    x.col(2) *= Real(0.02) + unit(random);
    return x;
}

std::vector<FeaturePair> features_of(const std::vector<NearPair>& pairs) {
    std::vector<FeaturePair> features;
    for (const NearPair& pair : pairs) features.push_back(pair.features);
    std::ranges::sort(features);
    return features;
}

constexpr VolumeKind volumes[] = {VolumeKind::Sphere, VolumeKind::Aabb,   VolumeKind::Kdop14,
                                  VolumeKind::Kdop18, VolumeKind::Kdop26, VolumeKind::Obb};

TEST(NearPairs, OfTwoClothsAreThoseOfBruteForce) {
    std::mt19937 random(2);
    for (const VolumeKind volume : volumes) {
        std::int64_t found = 0;
        for (int trial = 0; trial < 12; ++trial) {
            const Grid grid{9 + trial % 5, 8}, other_grid{7, 11};
            SearchedCloth cloth(0, grid, {.volume = volume, .leaf_cells = 2}),
                brute(0, grid, {.volume = VolumeKind::Brute});
            SearchedCloth other(1, other_grid, {.volume = volume, .leaf_cells = 3});
            SearchedCloth other_brute(1, other_grid, {.volume = VolumeKind::Brute});
            const Points x = squeezed_cloth(grid, random), y = squeezed_cloth(other_grid, random);
            for (SearchedCloth* one : {&cloth, &brute}) one->build(x);
            for (SearchedCloth* one : {&other, &other_brute}) one->build(y);
            const Real margin = Real(0.05);
            const auto expected = features_of(pairs_within(brute, other_brute, margin));
            found += static_cast<std::int64_t>(expected.size());
            ASSERT_EQ(features_of(pairs_within(cloth, other, margin)), expected) << name_of(volume);
        }
        EXPECT_GT(found, 1000);
    }
}

TEST(NearPairs, OfFlatSheetsOneAboveTheOtherAreAnsweredForOnce) {
    // Particles above particles, edges above edges: each of the first cloth's particles meets one of the second
    const Grid grid{4, 4};
    ClothParameters parameters;
    parameters.particles = grid;
    Points x = make_rest_state(parameters).x, y = x;
    y.col(1).array() += Real(0.01);
    SearchedCloth first(0, grid, {.volume = VolumeKind::Brute}), second(1, grid, {.volume = VolumeKind::Brute});
    first.build(x);
    second.build(y);
    std::vector<int> times(static_cast<std::size_t>(grid.particles()));
    for (const NearPair& pair : pairs_within(first, second, Real(0.02))) {
        if (pair.is_representative && pair.features.first_count == 1) {
            ++times[static_cast<std::size_t>(pair.features.particles[0])];
        }
    }
    EXPECT_EQ(times, std::vector<int>(times.size(), 1));
}

/// The distance of two segments by many points on them, each against the whole other one.
Real sampled_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Real least = distance_to_segment(a, c, d);
    for (int k = 0; k <= 1000; ++k) {
        const Real s = Real(k) / 1000;
        least =
            std::min({least, distance_to_segment(a + s * (b - a), c, d), distance_to_segment(c + s * (d - c), a, b)});
    }
    return least;
}

TEST(Segments, AreAsFarApartAsManyPointsOnThemSay) {
    std::mt19937 random(5);
    std::normal_distribution<Real> normal;
    const auto point = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3 a = point(), b = point(), c = point();
        // Any; parallel; on one line; a point; ever nearer to parallel
        const Vec3 directions[] = {point(), b - a, b - a, Vec3(0, 0, 0),
                                   (b - a) + std::pow(Real(10), -Real(trial % 9)) * point()};
        const auto kind = static_cast<std::size_t>(trial % 5);
        const Vec3 from = kind == 2 ? Vec3(a + normal(random) * (b - a)) : c;
        const Vec3 to = from + normal(random) * directions[kind];
        const ClosestOfSegments closest = closest_of_segments(a, b, from, to);
        const Real distance = closest.offset.norm(), sampled = sampled_distance(a, b, from, to);
        ASSERT_LE(distance, sampled + 1e-12) << trial;
        ASSERT_GE(distance, sampled - 1e-3 * ((b - a).norm() + (to - from).norm())) << trial;
        const Vec3 between = (a + closest.first * (b - a)) - (from + closest.second * (to - from));
        ASSERT_NEAR((between - closest.offset).norm(), 0, 1e-12) << trial;
    }
}

}  // namespace
}  // namespace drape
