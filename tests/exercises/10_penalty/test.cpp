#include <gtest/gtest.h>

#include <cmath>

#include EXERCISE

namespace exercise_10 {

/// Whether a spring of 1000 N/m on 0.1 kg, from 1 m at rest, grows at this step.
inline bool grows(double zeta, double h) {
    const double k = 1000, m = 0.1;
    double x = 1, v = 0;
    for (int step = 0; step < 4000 && std::abs(x) < 100; ++step) {
        v -= h * (k * x + 2 * zeta * std::sqrt(k * m) * v) / m;
        x += h * v;
    }
    return !(std::abs(x) < 100);
}

}  // namespace exercise_10

TEST(PenaltyStep, IsTheLongestThatStaysBounded) {
    for (const double zeta : {0.0, 0.2, 1.0}) {
        const double h = exercise_10::longest_step(1000, drape::Real(0.1), drape::Real(zeta));
        ASSERT_GT(h, 0) << "Hint: a spring alone has the limit 2 sqrt(m / k).";
        EXPECT_FALSE(exercise_10::grows(zeta, 0.99 * h))
            << "Hint: too long at zeta = " << zeta << "; with w = h sqrt(k / m) the limit is w^2 + 4 zeta w = 4.";
        EXPECT_TRUE(exercise_10::grows(zeta, 1.01 * h))
            << "Hint: too short at zeta = " << zeta << "; at the limit the eigenvalue of the step is -1.";
    }
}
