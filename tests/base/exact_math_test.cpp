#include "drape/base/exact_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace drape {
namespace {

TEST(ExactMath, IsThatOfTheCLibraryButForRounding) {
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    for (int i = 1; i <= 20'000; ++i) {
        const double x = 0.37 * i, y = 0.007 * i - 70;
        ASSERT_NEAR(sine(x), std::sin(x), rounding) << x;
        ASSERT_NEAR(natural_log(x), std::log(x), rounding * std::abs(std::log(x))) << x;
        ASSERT_NEAR(exponential(y), std::exp(y), rounding * std::exp(y)) << y;
    }
    for (const double x : {2e7, 1e9 + 0.3, 1e12 + 0.7}) {
        EXPECT_NEAR(sine(x), std::sin(x), x * std::numeric_limits<double>::epsilon()) << x;
    }
}

TEST(ExactMath, HasZerosInfinitiesAndWhatIsNoNumber) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(sine(0), 0);
    EXPECT_EQ(natural_log(1), 0);
    EXPECT_EQ(natural_log(0), -infinity);
    EXPECT_EQ(natural_log(infinity), infinity);
    EXPECT_TRUE(std::isnan(natural_log(-1)));
    EXPECT_EQ(exponential(0), 1);
    EXPECT_EQ(exponential(1e9), infinity);
    EXPECT_EQ(exponential(-1e9), 0);
}

/// The bits of these were found once; a compiler, flag or processor that gives others breaks a promise.
TEST(ExactMath, HasTheseBitsEverywhere) {
    std::uint64_t bits = 0;
    for (int i = 1; i <= 20'000; ++i) {
        for (const double value : {sine(0.37 * i), natural_log(0.37 * i), exponential(0.007 * i - 70)}) {
            bits = std::rotl(bits, 1) ^ std::bit_cast<std::uint64_t>(value);
        }
    }
    EXPECT_EQ(bits, 6989101222578585476u);
}

TEST(EvenDraw, FillsTheIntervalEvenlyInBothPrecisions) {
    std::mt19937 random(1);
    double sum = 0, square = 0;
    constexpr int count = 100'000;
    for (int i = 0; i < count; ++i) {
        const double x = uniform<double>(random);
        const float y = uniform<float>(random);
        ASSERT_TRUE(x >= -1 && x < 1 && y >= -1 && y < 1);
        sum += x + static_cast<double>(y);
        square += x * x + static_cast<double>(y * y);
    }
    EXPECT_NEAR(sum / (2 * count), 0, 0.01);
    EXPECT_NEAR(square / (2 * count), 1.0 / 3, 0.01);
}

}  // namespace
}  // namespace drape
