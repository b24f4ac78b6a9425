#include "drape/base/exact_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>

namespace drape {
namespace {

/// The largest error against the C library's long double, in units of the result's last place, over numbers from
/// `least` to `most`, each as likely in every binade.
double largest_error(double (*ours)(double), const std::function<long double(long double)>& truth, double least,
                     double most) {
    std::mt19937 random(1);
    double largest = 0;
    for (int i = 0; i < 300'000; ++i) {
        const double place = (uniform<double>(random) + 1) / 2;
        const double x = least * std::pow(most / least, place);
        for (const double signed_x : {x, -x}) {
            const long double exact = truth(static_cast<long double>(signed_x));
            if (std::isnan(exact)) continue;
            const double near = std::abs(static_cast<double>(exact));
            const double ulp = std::nextafter(near, std::numeric_limits<double>::infinity()) - near;
            const auto error = static_cast<double>(std::abs(static_cast<long double>(ours(signed_x)) - exact));
            largest = std::max(largest, error / ulp);
        }
    }
    return largest;
}

TEST(ExactMath, HasSinesToOneUnitInTheLastPlace) {
    const auto truth = [](long double x) { return std::sin(x); };
    EXPECT_LT(largest_error(sine, truth, 1e-300, 1e-3), 1);
    EXPECT_LT(largest_error(sine, truth, 1e-3, 10), 1);
    EXPECT_LT(largest_error(sine, truth, 10, 1e7), 1);
    EXPECT_EQ(sine(0), 0);
    // Next to multiples of pi, where all digits of a hasty reduction cancel
    for (int n = 1; n < 1'000'000; n += 37) {
        const double x = n * 3.14159265358979323846, exact = static_cast<double>(std::sin(static_cast<long double>(x)));
        EXPECT_NEAR(sine(x), exact, 4e-16 * std::abs(exact)) << x;
    }
    // Of large numbers within their rounding
    for (const double x : {2e7, 1e9 + 0.3, 1e12 + 0.7}) {
        const double exact = static_cast<double>(std::sin(static_cast<long double>(x)));
        EXPECT_NEAR(sine(x), exact, x * std::numeric_limits<double>::epsilon()) << x;
    }
}

TEST(ExactMath, HasLogarithmsToOneUnitInTheLastPlace) {
    const auto truth = [](long double x) {
        return x > 0 ? std::log(x) : std::numeric_limits<long double>::quiet_NaN();
    };
    const auto positive = [](double x) { return x > 0 ? natural_log(x) : 0; };
    EXPECT_LT(largest_error(positive, truth, 1e-320, 1e300), 1);
    EXPECT_LT(largest_error(positive, truth, 0.5, 2), 1);
    EXPECT_LT(largest_error(positive, truth, 1 - 1e-6, 1 + 1e-6), 1);
    EXPECT_EQ(natural_log(1), 0);
    EXPECT_EQ(natural_log(0), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(natural_log(std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(natural_log(-1)));
}

TEST(ExactMath, HasExponentialsToOneUnitInTheLastPlace) {
    const auto truth = [](long double x) { return std::exp(x); };
    EXPECT_LT(largest_error(exponential, truth, 1e-20, 1), 1);
    EXPECT_LT(largest_error(exponential, truth, 1, 700), 1);
    EXPECT_EQ(exponential(0), 1);
    EXPECT_EQ(exponential(1e9), std::numeric_limits<double>::infinity());
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
