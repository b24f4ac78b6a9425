#include <gtest/gtest.h>

#include EXERCISE

using drape::Real, drape::SpringLaw, drape::Vec3;

TEST(Springs, PullWhatIsStretchedAndPushWhatIsShortened) {
    const SpringLaw law{100, 0};
    const Vec3 f = exercise_01::spring_force(law, 2, {0, 0, 3}, Vec3::Zero());
    EXPECT_NEAR(f.z(), -100, 1e-3) << "Hint: k times elongation, here 100 N/m times 1 m, towards the other end.";
    EXPECT_NEAR(exercise_01::spring_force(law, 2, {1, 0, 0}, Vec3::Zero()).x(), 100, 1e-3)
        << "Hint: the elongation has a sign; a spring that is too short pushes.";
}

TEST(Springs, AreDampedAlongTheirDirectionOnly) {
    const SpringLaw law{0, 5};
    EXPECT_NEAR(exercise_01::spring_force(law, 2, {2, 0, 0}, {3, 0, 0}).x(), -15, 1e-3)
        << "Hint: c times the part of w along n = d/|d|, against it.";
    EXPECT_NEAR(exercise_01::spring_force(law, 2, {2, 0, 0}, {0, 3, 0}).norm(), 0, 1e-3)
        << "Hint: a velocity across the spring does not change its length.";
}

TEST(Springs, OfNoLengthGiveNoForce) {
    EXPECT_EQ(exercise_01::spring_force({100, 5}, 2, Vec3::Zero(), {3, 0, 0}).norm(), 0)
        << "Hint: where |d| = 0, d/|d| is 0/0; a spring without a direction gives no force.";
}
