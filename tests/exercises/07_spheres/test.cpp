#include <gtest/gtest.h>

#include EXERCISE

TEST(EnclosingSphere, TouchesBothOnTheLineOfTheirCentres) {
    const drape::BoundingSphere s = exercise_07::enclosing({{0, 0, 0}, 1}, {{0, 6, 0}, 2});
    EXPECT_NEAR(s.radius, 4.5, 1e-4) << "Hint: its diameter runs from -1 to 8 on the line through both centres.";
    EXPECT_NEAR(s.centre.y(), 3.5, 1e-4) << "Hint: the middle of that diameter, not the middle of the two centres.";
}

TEST(EnclosingSphere, IsTheLargerOneWhereThatContainsTheOther) {
    EXPECT_NEAR(exercise_07::enclosing({{0, 0, 0}, 5}, {{1, 0, 0}, 2}).radius, 5, 1e-4)
        << "Hint: one contains the other where the distance of the centres is at most the difference of the radii.";
    EXPECT_NEAR(exercise_07::enclosing({{1, 0, 0}, 2}, {{0, 0, 0}, 5}).radius, 5, 1e-4)
        << "Hint: either of the two may be the larger one.";
    EXPECT_NEAR(exercise_07::enclosing({{1, 0, 0}, 2}, {{1, 0, 0}, 2}).centre.x(), 1, 1e-4)
        << "Hint: equal centres have no direction between them; do not divide by their distance.";
}
