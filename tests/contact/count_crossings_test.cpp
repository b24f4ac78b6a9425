// What counts as a crossing: beside the exact count, which knows the last bit, that of the programs, which leaves what
// rounding may have made.

#include "drape/contact/near_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/crossings.h"

namespace drape {
namespace {

const Grid one_cell{2, 2};

/// Two cloths of one cell each.
struct TwoCells {
    Points first = Points(4, 3), second = Points(4, 3);

    /// @return by the programs' count and by the exact one
    [[nodiscard]] std::pair<std::int64_t, std::int64_t> counts() const {
        std::array<CellBoxes, 2> boxes;
        boxes[0].build(one_cell, first), boxes[1].build(one_cell, second);
        const BoxedCloth one{{0, one_cell, first}, boxes[0]}, two{{1, one_cell, second}, boxes[1]};
        const LeafPair all{all_cells(one_cell), all_cells(one_cell)};
        return {count_crossings(one, two, {&all, 1}), test::crossings(one, two)};
    }
};

using Counts = std::pair<std::int64_t, std::int64_t>;

/// The first lies flat at a height, the second stands on a corner, whose two edges go down to another height.
TwoCells standing_on(Real height, Real corner) {
    TwoCells cells;
    cells.first << 0, height, 0, 1, height, 0, 0, height, 1, 1, height, 1;
    const auto a = Real(0.25), b = Real(0.5), above = height + 1;
    cells.second << a, corner, a, b, above, a, a, above, b, b, above, b;
    return cells;
}

TEST(CountCrossings, CountsNothingThatOnlyTouches) {
    for (const Real height : {Real(0), Real(1), Real(-300)}) {
        EXPECT_EQ(standing_on(height, height).counts(), Counts(0, 0)) << height;
        EXPECT_EQ(standing_on(height, std::nextafter(height, height + 1)).counts(), Counts(0, 0)) << height;
    }
    // A corner on an edge, and an edge along an edge
    TwoCells cells = standing_on(1, 1);
    cells.second.row(0) << Real(0.5), 1, Real(0.5);
    EXPECT_EQ(cells.counts(), Counts(0, 0));
    cells.second.row(1) = cells.first.row(1);
    EXPECT_EQ(cells.counts(), Counts(0, 0));
}

TEST(CountCrossings, IsExactToTheLastBitWhereItIsTheOracle) {
    for (const Real height : {Real(1), Real(-300)}) {
        const TwoCells cells = standing_on(height, std::nextafter(height, height - 1));
        EXPECT_EQ(cells.counts(), Counts(0, 2)) << "one bit: a crossing by exact arithmetic, by doubles rounding";
    }
}

TEST(CountCrossings, CountsWhatIsMoreThanRounding) {
    const Real bits = std::numeric_limits<Real>::epsilon();
    for (const Real height : {Real(0), Real(1), Real(-300)}) {
        const Real size = std::max(Real(1), std::abs(height));
        EXPECT_EQ(standing_on(height, height - 1000 * bits * size).counts(), Counts(2, 2)) << height;
    }
}

TEST(CountCrossings, AgreesWithExactArithmeticOnTrianglesAtRandom) {
    std::mt19937 random(4);
    std::uniform_real_distribution<Real> unit(-1, 1);
    std::int64_t all = 0;
    for (int trial = 0; trial < 5000; ++trial) {
        TwoCells cells;
        for (Points* x : {&cells.first, &cells.second}) {
            *x = Points::NullaryExpr(4, 3, [&](Eigen::Index, Eigen::Index) { return unit(random); });
        }
        const auto [counted, exact] = cells.counts();
        ASSERT_EQ(counted > 0, exact > 0) << trial;
        all += counted;
    }
    EXPECT_GT(all, 5000);
}

}  // namespace
}  // namespace drape
