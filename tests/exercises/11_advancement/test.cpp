#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include EXERCISE

namespace exercise_11 {

int measured = 0;
constexpr auto too_many = "Hint: a thousand measurements. Advance by the whole distance; less may never arrive.";

/// A point at 4 m/s along x, from 2 m before a ball of radius 0.1 m; its path passes the centre at a distance.
inline std::optional<drape::Real> shot(drape::Real offset) {
    measured = 0;
    const auto gap = [&](drape::Real t) {
        if (++measured > 1000) throw std::runtime_error(too_many);
        return std::hypot(4 * t - 2, offset) - drape::Real(0.1);
    };
    return first_contact(gap, 4, drape::Real(1e-3));
}

}  // namespace exercise_11

TEST(FirstContact, IsSeenWithinTheStep) {
    const auto time = exercise_11::shot(0);
    ASSERT_TRUE(time) << "Hint: the point is in front of the ball at 0 and behind it at 1. From t you may advance to "
                         "t + distance / speed, for until then they cannot meet.";
    EXPECT_NEAR(*time, 1.9 / 4, 1e-3) << "Hint: return the first t at which the distance is at most near.";
}

TEST(FirstContact, MissesNoGrazingHitAndInventsNone) {
    EXPECT_TRUE(exercise_11::shot(drape::Real(0.099))) << "Hint: equal parts of the step are not safe; gaps are.";
    EXPECT_FALSE(exercise_11::shot(drape::Real(0.105))) << "Hint: it passes at 5 mm; past t = 1 there is no contact.";
    EXPECT_LT(exercise_11::measured, 200) << "Hint: far away, advance by the whole gap.";
}

TEST(FirstContact, MayBeAtTheEnd) {
    const auto time = exercise_11::first_contact([](drape::Real t) { return 1 - t; }, 1, 0);
    EXPECT_TRUE(time) << "Hint: the step ends at t = 1, and that belongs to it.";
}
