// Pairs of features of folded sheets: hierarchy, cones and cells against the definition, over very many sheets; and
// motions that end in a touch.

#include <gtest/gtest.h>

#include <algorithm>

#include "drape/contact/closest_point.h"
#include "drape/contact/impact_zones.h"
#include "searched_cloth.h"
#include "support/cloths.h"
#include "support/exact_distance.h"
#include "support/sanitized.h"

namespace drape {
namespace {

/// A flat sheet of 1 m that is folded over across one to three random lines, each layer a little above the other, and
/// ruffled a little.
Points folded_sheet(const Grid& grid, std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    ClothParameters parameters;
    parameters.particles = grid;
    parameters.centred = true;
    Points x = make_rest_state(parameters).x;
    for (auto folds = 1 + random() % 3; folds > 0; --folds) {
        const Real angle = 4 * unit(random), offset = Real(0.4) * unit(random);
        const Real gap = Real(0.02) * std::abs(unit(random)), slope = Real(0.3) * unit(random) * unit(random);
        const Real along_x = std::cos(angle), along_z = std::sin(angle);
        for (Eigen::Index p = 0; p < x.rows(); ++p) {
            const Real beyond = along_x * x(p, 0) + along_z * x(p, 2) - offset;
            if (beyond <= 0) continue;
            x(p, 0) -= 2 * beyond * along_x, x(p, 2) -= 2 * beyond * along_z;
            x(p, 1) += gap + slope * beyond;
        }
    }
    const Real noise = Real(0.01) * std::abs(unit(random));
    for (Real& value : x.reshaped()) value += noise * unit(random);
    return x;
}

/// One grid with a hierarchy, and all of its features.
struct FoldedSheet : test::SearchedCloth {
    FoldedSheet(const Grid& its_grid, VolumeKind volume, int leaf_cells)
        : SearchedCloth(0, its_grid, {.volume = volume, .leaf_cells = leaf_cells}) {
        for (int t = 0; t < grid.triangles(); ++t) {
            const auto c = grid.triangle_corners(t);
            for (const auto& [a, b] : {std::minmax(c[0], c[1]), std::minmax(c[1], c[2]), std::minmax(c[2], c[0])})
                edges.push_back({a, b});
        }
        std::ranges::sort(edges);
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    }

    [[nodiscard]] std::vector<FeaturePair> defined(Real margin) const {
        std::vector<FeaturePair> pairs;
        for (int p = 0; p < grid.particles(); ++p) {
            for (int t = 0; t < grid.triangles(); ++t) {
                const auto c = grid.triangle_corners(t);
                if (std::ranges::count(c, p) > 0 || distance_to_triangle(at(p), grid, x, t) >= margin) continue;
                pairs.push_back({{0, 0}, 1, {p, c[0], c[1], c[2]}});
            }
        }
        for (std::size_t e = 0; e < edges.size(); ++e) {
            for (std::size_t f = e + 1; f < edges.size(); ++f) {
                const auto& [a, b] = edges[e];
                const auto& [c, d] = edges[f];
                if (a == c || a == d || b == c || b == d) continue;
                if (closest_of_segments(at(a), at(b), at(c), at(d)).offset.norm() < margin)
                    pairs.push_back({{0, 0}, 2, {a, b, c, d}});
            }
        }
        std::ranges::sort(pairs);
        return pairs;
    }

    std::vector<std::array<int, 2>> edges;
};

/// Edges in one order, whatever order the cells gave them.
std::vector<FeaturePair> in_order(const std::vector<NearPair>& found) {
    std::vector<FeaturePair> pairs;
    for (const NearPair& pair : found) {
        FeaturePair features = pair.features;
        auto& [a, b, c, d] = features.particles;
        if (features.first_count == 2) {
            if (a > b) std::swap(a, b);
            if (c > d) std::swap(c, d);
            if (std::pair(c, d) < std::pair(a, b)) std::swap(a, c), std::swap(b, d);
        }
        pairs.push_back(features);
    }
    std::ranges::sort(pairs);
    return pairs;
}

/// Its weights, normal and distance are those of two points of the features.
void expect_closest(const FoldedSheet& sheet, const NearPair& pair) {
    Vec3 offset = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) offset += pair.signed_weight(k) * sheet.at(pair.features.particles[k]);
    ASSERT_NEAR((offset - pair.distance * pair.normal).norm(), 0, 1e-12);
    ASSERT_NEAR(pair.normal.norm(), 1, 1e-12);
}

/// The first feature goes straight to the second, and touches it at the very end of the way.
void expect_held_back(const FoldedSheet& sheet, const NearPair& pair) {
    FeatureMotion motion{.first_count = pair.features.first_count};
    for (std::size_t k = 0; k < 4; ++k) {
        motion.start[k] = sheet.at(pair.features.particles[k]);
        motion.displacement[k] =
            pair.features.feature_of(k) == 0 ? Vec3(-pair.distance * pair.normal) : Vec3(Vec3::Zero());
    }
    const Real part = safe_part_of(motion, pair.distance, Real(1e-9));
    ASSERT_LT(part, 1) << "a touch at the end of the way";
    ASSERT_GT(motion.distance_after(part), 0);
}

class FoldedPairs : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Sheets, FoldedPairs, testing::Values(test::sanitized ? 2'000 : 20'000));
INSTANTIATE_TEST_SUITE_P(Nightly, FoldedPairs, testing::Values(2'000'000));

TEST_P(FoldedPairs, AreThoseOfTheDefinition) {
    std::mt19937 random(11);
    std::uniform_real_distribution<Real> unit(0, 1);
    std::vector<FoldedSheet> sheets;
    for (const VolumeKind volume : {VolumeKind::Sphere, VolumeKind::Aabb, VolumeKind::Kdop14, VolumeKind::Kdop18,
                                    VolumeKind::Kdop26, VolumeKind::Obb}) {
        for (const Grid& grid : {Grid{4, 4}, Grid{5, 3}, Grid{4, 6}}) sheets.emplace_back(grid, volume, 1);
        for (const Grid& grid : {Grid{2, 6}, Grid{6, 5}}) sheets.emplace_back(grid, volume, 2);
    }
    std::int64_t found = 0, touched = 0;
    for (int trial = 0; trial < GetParam(); ++trial) {
        FoldedSheet& sheet = sheets[static_cast<std::size_t>(trial) % sheets.size()];
        sheet.build(folded_sheet(sheet.grid, random));
        const Real margin = Real(0.05) * unit(random);
        const std::vector<NearPair> pairs = pairs_within(sheet, sheet, margin);
        ASSERT_EQ(in_order(pairs), sheet.defined(margin)) << "sheet " << trial << ", margin " << margin;
        found += static_cast<std::int64_t>(pairs.size());
        if (pairs.empty()) continue;
        const NearPair& pair = pairs[random() % pairs.size()];
        if (pair.distance < Real(1e-6)) continue;
        ASSERT_NO_FATAL_FAILURE(expect_closest(sheet, pair)) << "sheet " << trial;
        ASSERT_NO_FATAL_FAILURE(expect_held_back(sheet, pair)) << "sheet " << trial;
        ++touched;
    }
    EXPECT_GT(found, 5 * GetParam());
    EXPECT_GT(touched, GetParam() / 4);
}

}  // namespace
}  // namespace drape
