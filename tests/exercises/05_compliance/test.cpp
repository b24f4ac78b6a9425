#include <gtest/gtest.h>

#include EXERCISE

using drape::Real;

TEST(Compliance, OfZeroClosesAConstraintAtOnce) {
    const Real q = exercise_05::change(Real(0.3), 0, 0, Real(0.01), 2, 1);
    EXPECT_NEAR(0.3 + (2 + 1) * q, 0, 1e-9) << "Hint: both ends move, by w_a q and w_b q; q is against the elongation. "
                                               "Never divide by the compliance, which is 0 here.";
}

TEST(Compliance, LeavesTheElongationOfBackwardEuler) {
    const Real h = Real(0.1), k = 300, c = Real(0.3), q = exercise_05::change(c, 0, 1 / k, h, 1, 0);  // z^2 = 3
    EXPECT_NEAR(c + q, c / (1 + 3), 1e-9) << "Hint: alpha is the compliance divided by the square of the step.";
}

TEST(Compliance, IsNotForgottenByASecondCorrection) {
    const Real h = Real(0.1), k = 300, c = Real(0.3), q = exercise_05::change(c, 0, 1 / k, h, 1, 0);
    EXPECT_NEAR(exercise_05::change(c + q, q, 1 / k, h, 1, 0), 0, 1e-9)
        << "Hint: the constraint is c + alpha q = 0; without alpha q, each correction makes the spring stiffer.";
}
