#include <gtest/gtest.h>

#include <cmath>

#include EXERCISE

using drape::Real, drape::Vec3;

namespace exercise_09 {

/// The speed down a slope of a block of 2 kg after a second from rest, mu = 0.5.
inline Real speed_after_a_second(Real angle) {
    const Vec3 n(std::sin(angle), std::cos(angle), 0);
    Vec3 v = Vec3::Zero();
    for (int step = 0; step < 100; ++step) {
        v.y() -= Real(9.81 / 100);
        drape::RowImpulse total;
        for (int sweep = 0; sweep < 3; ++sweep) solve_row(n, Real(0.5), Real(0.5), v, total);
    }
    return v.norm();
}

}  // namespace exercise_09

TEST(BlockOnASlope, SticksBelowTheFrictionAngleAndSlidesAbove) {
    EXPECT_NEAR(exercise_09::speed_after_a_second(Real(0.45)), 0, 1e-4)
        << "Hint: tan 0.45 < 0.5: normal impulse -v.n / inverse_mass, friction against what is left of v.";
    EXPECT_NEAR(exercise_09::speed_after_a_second(Real(0.6)), 9.81 * (std::sin(0.6) - 0.5 * std::cos(0.6)), 1e-3)
        << "Hint: tan 0.6 > 0.5: shorten the total friction to mu times the total normal impulse.";
}

TEST(BlockOnASlope, IsStoppedByASingleVisit) {
    Vec3 v(Real(0.25), -1, 0);
    drape::RowImpulse total;
    exercise_09::solve_row({0, 1, 0}, Real(0.5), Real(0.5), v, total);
    EXPECT_NEAR(v.norm(), 0, 1e-6) << "Hint: friction is bounded by mu times the new normal impulse, not the old one.";
    EXPECT_NEAR(total.friction.x(), -0.5, 1e-6) << "Hint: it is against the sliding; keep its total.";
}

TEST(BlockOnASlope, IsNeverPulledAndGivesBackWhatItHadTooMuch) {
    Vec3 v(0, 1, 0);
    drape::RowImpulse total;
    exercise_09::solve_row({0, 1, 0}, Real(0.5), Real(0.5), v, total);
    EXPECT_NEAR(v.y(), 1, 1e-6) << "Hint: the block leaves the ground; max(., 0) keeps the impulse from pulling.";
    total.normal = 3;  // by a warm start, which has thrown it up
    exercise_09::solve_row({0, 1, 0}, Real(0.5), Real(0.5), v, total);
    EXPECT_NEAR(v.y(), 0, 1e-6) << "Hint: clamp the total impulse, not its change: 3 N s become 1.";
    EXPECT_NEAR(total.normal, 1, 1e-6) << "Hint: and keep the total.";
}
