// The list of near pairs is what a plain search finds, in order, whatever the number of threads.

#include "drape/sim/pair_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/cloths.h"

namespace drape {
namespace {

/// A crumpled sheet, and leaves of two rows of cells that are all paired with each other.
struct CrumpledSheet {
    CrumpledSheet() {
        std::mt19937 random(7);
        x = Real(0.4) * test::random_cloth(grid, random);
        boxes.build(grid, x, reaches);
        const int columns = grid.cell_columns(), rows = grid.cell_rows();
        for (int one = 0; one < rows; one += 2) {
            for (int two = one; two < rows; two += 2) {
                leaves.push_back({{0, one, columns, one + 2}, {0, two, columns, two + 2}});
            }
        }
    }
    [[nodiscard]] BoxedCloth boxed() const { return {{0, grid, x}, boxes, reaches}; }

    Grid grid{25, 25};
    Points x;
    std::vector<Real> reaches = std::vector<Real>(25 * 25, Real(0.04));
    CellBoxes boxes;
    std::vector<LeafPair> leaves;
};

std::vector<NearPair> sorted_plain_search(const CrumpledSheet& sheet) {
    std::vector<NearPair> pairs;
    find_near_pairs(sheet.boxed(), sheet.boxed(), sheet.leaves, pairs);
    std::ranges::sort(pairs, {}, &NearPair::features);
    return pairs;
}

void expect_order_with_any_number_of_threads(const CrumpledSheet& sheet, const std::vector<NearPair>& expected) {
    for (const int threads : {1, 8}) {
        PairList list;
        list.use(threads);
        for (int rounds = threads == 1 ? 1 : 2; rounds > 0; --rounds) {
            list.clear();
            list.add(sheet.boxed(), sheet.boxed(), sheet.leaves);
            EXPECT_EQ(list.size(), expected.size());
            list.close();
            ASSERT_EQ(list.size(), expected.size());
            std::vector<NearPair> near;
            list.look_through(near, [&](const PairList::Listed& listed, std::vector<NearPair>& found) {
                NearPair pair{listed.features, listed.triangle};
                pair.distance = listed.distance;
                if (pair.distance < Real(0.06)) found.push_back(pair);
            });
            std::size_t at = 0;
            for (const NearPair& pair : expected) {
                if (pair.distance >= Real(0.06)) continue;
                ASSERT_LT(at, near.size());
                ASSERT_EQ(near[at].features, pair.features) << at << " of " << threads << " threads";
                ASSERT_EQ(near[at].distance, pair.distance);
                ++at;
            }
            EXPECT_EQ(at, near.size());
        }
    }
}

void expect_it_goes_on_with_another_number_and_in_a_copy(const CrumpledSheet& sheet,
                                                         const std::vector<NearPair>& plain) {
    PairList list;
    list.use(3);
    list.add(sheet.boxed(), sheet.boxed(), sheet.leaves);
    list.close();
    PairList copy = list;
    list.use(8);
    const auto keep = [](const PairList::Listed& listed, std::vector<NearPair>& found) {
        found.push_back({listed.features, listed.triangle});
    };
    std::vector<NearPair> near, near_in_copy;
    list.look_through(near, keep);
    list.use(1);
    copy.look_through(near_in_copy, keep);
    const auto features = [](const std::vector<NearPair>& pairs) {
        std::vector<FeaturePair> all;
        for (const NearPair& pair : pairs) all.push_back(pair.features);
        return all;
    };
    const std::vector<FeaturePair> expected = features(plain);
    EXPECT_EQ(features(near), expected);
    EXPECT_EQ(features(near_in_copy), expected);
}

/// One search for all, which takes longest.
TEST(PairList, IsWhatAPlainSearchFindsInOrderWithAnyNumberOfThreads) {
    const CrumpledSheet sheet;
    const std::vector<NearPair> expected = sorted_plain_search(sheet);
    ASSERT_GT(expected.size(), 8 * 1024U) << "enough for eight threads";
    expect_order_with_any_number_of_threads(sheet, expected);
    expect_it_goes_on_with_another_number_and_in_a_copy(sheet, expected);
}

}  // namespace
}  // namespace drape
