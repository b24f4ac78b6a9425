#include <gtest/gtest.h>

#include "drape/integrate/stability.h"
#include EXERCISE

using drape::IntegratorKind, drape::Real;

TEST(StepLimit, IsTwoByOmegaWithoutDamping) {
    EXPECT_NEAR(exercise_02::longest_step(100, 0), 0.2, 1e-9) << "Hint: |trace| <= 2, and omega is the root of k.";
}

TEST(StepLimit, IsShorterWithDamping) {
    for (const Real d : {1., 20., 300.}) {
        const Real right = drape::longest_step(IntegratorKind::SymplecticEuler, 100, d);
        EXPECT_NEAR(exercise_02::longest_step(100, d) / right, 1, 1e-6)
            << "d = " << d << ". Hint: 1 + trace + determinant = 0 is a quadratic in h; the determinant is 1 - h d.";
    }
    EXPECT_NEAR(exercise_02::longest_step(0, 10), 0.2, 1e-9)
        << "Hint: (sqrt(d^2 + 4 k) - d) / k is 0/0 without a spring; multiply both by sqrt(d^2 + 4 k) + d.";
}
