#include <gtest/gtest.h>

#include <utility>

#include EXERCISE

TEST(FramesBetweenRebuilds, HaveTheLeastMeanCost) {
    using Costs = std::pair<double, double>;
    for (const auto& [rebuild, growth] :
         {Costs(10, 20), Costs(21, 20), Costs(10, 1), Costs(10, 0.1), Costs(65, 0.02)}) {
        const auto mean = [r = rebuild, g = growth](int n) { return (r + g * n * (n - 1) / 2) / n; };
        const int n = exercise_08::frames_between_rebuilds(drape::Real(rebuild), drape::Real(growth));
        ASSERT_GE(n, 1) << "Hint: a period has at least the frame of the rebuild.";
        EXPECT_LE(mean(n), mean(n + 1) * (1 + 1e-6))
            << "Hint: too often for " << rebuild << " and " << growth
            << ": one frame more has a lesser mean, (rebuild + growth n (n - 1) / 2) / n.";
        if (n == 1) continue;
        EXPECT_LE(mean(n), mean(n - 1) * (1 + 1e-6)) << "Hint: too seldom for " << rebuild << " and " << growth
                                                     << ": growth 0 + growth 1 + ... adds up to growth n (n - 1) / 2.";
    }
}
