#include <gtest/gtest.h>

#include EXERCISE

using drape::Vec3;

TEST(SegmentAndTriangle, CrossWhereTheSegmentPassesInside) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), above(0.2f, 0.2f, 1), below(0.3f, 0.3f, -1);
    EXPECT_TRUE(exercise_12::crosses(above, below, a, b, c))
        << "Hint: the ends are on different sides of the plane: (b - a) x (c - a) . (p - a) changes its sign, and seen "
           "along the segment all three sides turn the same way.";
    EXPECT_TRUE(exercise_12::crosses(below, above, a, b, c) && exercise_12::crosses(above, below, a, c, b))
        << "Hint: neither the direction of the segment nor the order of the corners counts; only equal signs do.";
}

TEST(SegmentAndTriangle, DoNotCrossBesideOrShortOfIt) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    EXPECT_FALSE(exercise_12::crosses({0.2f, 0.2f, 2}, {0.2f, 0.2f, 1}, a, b, c))
        << "Hint: both ends are on one side of the plane.";
    for (const Vec3& beside : {Vec3(2, 2, 0), Vec3(-1, 0.2f, 0), Vec3(0.2f, -1, 0), Vec3(3, -1, 0), Vec3(-1, 3, 0)}) {
        EXPECT_FALSE(exercise_12::crosses(beside + Vec3(0, 0, 1), beside - Vec3(0, 0, 1), a, b, c))
            << "Hint: it crosses the plane, but beside the triangle: one of p q a b, p q b c, p q c a has another "
               "sign.";
    }
}
