// The first touch of a moving ball and a moving triangle, against plain search in long double, to 1e-4 of the sizes.
// Built in both precisions.

#include "drape/contact/impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/moving_triangle.h"

namespace drape {
namespace {

using Corners = std::array<Vec3, 3>;
using FirstImpact = std::optional<Impact> (*)(const SweptBall&, const Corners&, const Corners&);

constexpr Real touch_tolerance = Real(1e-4);
constexpr Real near_the_end = Real(0.99);
const Corners resting{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)};

/// A ball that falls by 2 past the resting triangle.
std::optional<Impact> falling_from(Real x, Real z) {
    const SweptBall ball{.start = Vec3(x, 1, z), .end = Vec3(x, -1, z), .radius = Real(0.1)};
    return first_impact(ball, resting, resting);
}

TEST(FirstImpact, OnTheFaceIsWhereThePlaneIsARadiusAway) {
    const auto impact = falling_from(Real(0.25), Real(0.25));
    ASSERT_TRUE(impact.has_value());
    EXPECT_NEAR(impact->time, 0.45, touch_tolerance);
    EXPECT_NEAR(impact->barycentric[0], 0.5, touch_tolerance);
    EXPECT_NEAR(impact->barycentric[1], 0.25, touch_tolerance);
    EXPECT_NEAR(impact->normal.y(), -1, touch_tolerance);
}

TEST(FirstImpact, ThatGrazesAnEdgeCountsAndIsNoneBesideIt) {
    const auto impact = falling_from(Real(-0.0999), Real(0.5));
    ASSERT_TRUE(impact.has_value());
    EXPECT_NEAR(impact->time, 0.5, 0.01);
    EXPECT_NEAR(impact->normal.x(), 1, 0.01);
    EXPECT_FALSE(falling_from(Real(-0.100001), Real(0.5)).has_value());
}

TEST(FirstImpact, IsAtOnceIfTheyTouchAlready) {
    const SweptBall ball{.start = Vec3(Real(0.2), Real(0.05), Real(0.2)), .end = Vec3(5, 5, 5), .radius = Real(0.1)};
    ASSERT_TRUE(first_impact(ball, resting, resting).has_value());
    EXPECT_EQ(first_impact(ball, resting, resting)->time, 0);
    const SweptBall still{.start = ball.start, .end = ball.start, .radius = Real(0.1)};
    EXPECT_EQ(first_impact(still, resting, resting)->time, 0);
    const SweptBall apart{.start = ball.end, .end = ball.end, .radius = Real(0.1)};
    EXPECT_FALSE(first_impact(apart, resting, resting).has_value());
    const SweptBall centred{.start = Vec3(Real(0.2), 0, Real(0.2)), .end = Vec3(0, 9, 0), .radius = Real(0.1)};
    ASSERT_TRUE(first_impact(centred, resting, resting).has_value());
    EXPECT_NEAR(first_impact(centred, resting, resting)->normal.norm(), 1, touch_tolerance);
}

TEST(FirstImpact, AtTheVeryEndOfTheStepCounts) {
    for (const Real x : {Real(0.25), Real(0.5), Real(0)}) {
        const SweptBall ball{
            .start = Vec3(x, 2, Real(0.25)), .end = Vec3(x, Real(0.4999), Real(0.25)), .radius = Real(0.5)};
        const auto impact = first_impact(ball, resting, resting);
        ASSERT_TRUE(impact.has_value()) << x;
        EXPECT_NEAR(impact->time, 1, touch_tolerance);
    }
}

/// The plane comes as near twice: past the triangle at first, then as it turns.
TEST(FirstImpact, MayBeTheSecondTimeThatThePlaneIsNear) {
    const Corners from{Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(3, 1, 0)}, to{Vec3(1, 0, -1), Vec3(1, 0, 1), Vec3(-9, 0, 0)};
    const SweptBall ball{.start = Vec3(0, Real(0.05), 0), .end = Vec3(0, Real(0.05), 0), .radius = Real(0.02)};
    const auto impact = first_impact(ball, from, to);
    ASSERT_TRUE(impact.has_value());
    const test::MovingTriangle truth(ball, from, to);
    EXPECT_NEAR(static_cast<Real>(truth.distance(impact->time)), ball.radius, touch_tolerance * ball.radius);
    EXPECT_FALSE(truth.comes_within(ball.radius * Real(0.999), impact->time - Real(1e-3)));
}

/// Steps of all kinds, drawn at random.
class RandomSteps {
public:
    struct Step {
        SweptBall ball;
        Corners from, to;
        [[nodiscard]] Real size() const {
            Real largest = ball.radius;
            for (std::size_t k = 0; k < 3; ++k) {
                largest = std::max({largest, (from[k] - ball.start).norm(), (to[k] - ball.end).norm()});
            }
            return largest;
        }
    };

    /// @param kind even ones are of any shape, others degenerate, still or aimed
    Step draw(int kind) {
        Step step;
        step.ball = {.start = 3 * point(), .end = 3 * point(), .radius = Real(0.3) * (1 + unit(random_)) + Real(0.001)};
        for (std::size_t k = 0; k < 3; ++k) step.from[k] = point(), step.to[k] = step.from[k] + point();
        switch (kind % 8) {
            case 1:
                squeeze(step);
                break;
            case 3:
                aim(step);
                break;
            case 5:  // nothing moves, or all does alike
                step.to = step.from;
                if (random_() % 2 == 0) step.ball.end = step.ball.start;
                break;
            case 7:  // a bullet at a small triangle
                step.ball.radius = Real(0.012);
                for (Vec3& corner : step.from) corner = Real(0.03) * point();
                for (std::size_t k = 0; k < 3; ++k) step.to[k] = step.from[k] + Real(0.01) * point();
                step.ball.start = point();
                step.ball.end = Real(-0.8) * step.ball.start + Real(0.03) * point();
                break;
            default:
                break;
        }
        return step;
    }

private:
    Vec3 point() { return {unit(random_), unit(random_), unit(random_)}; }

    /// To a needle, a line or a point.
    void squeeze(Step& step) {
        const Real width = std::array{Real(1e-3), Real(1e-6), Real(1e-9), Real(0)}[random_() % 4];
        const Vec3 a = point();
        for (Corners* corners : {&step.from, &step.to}) {
            (*corners)[1] = (*corners)[0] + (random_() % 2 == 0 ? a : Vec3(width * a));
            (*corners)[2] = (*corners)[0] + unit(random_) * a + width * point();
        }
        step.ball.end = Real(-0.5) * step.ball.start;
    }

    /// At a touch hardly before the step's end, of the inside, an edge or a corner.
    void aim(Step& step) {
        Real v = (1 + unit(random_)) / 2, w = (1 - v) * (1 + unit(random_)) / 2;
        if (random_() % 3 == 0) v = 0;
        if (random_() % 3 == 0) w = 0;
        const auto& [a, b, c] = step.to;
        const Vec3 side = v > 0 && w > 0 ? Vec3((b - a).cross(c - a)) : point();
        const Real depth = random_() % 2 == 0 ? touch_tolerance / 2 : 20 * touch_tolerance;
        step.ball.end = a + v * (b - a) + w * (c - a) + (step.ball.radius - depth) * side.normalized();
        step.ball.start = step.ball.end + side;
    }

    std::mt19937 random_{23};
    std::uniform_real_distribution<Real> unit{-1, 1};
};

struct Outcome {
    long impacts = 0, at_once = 0, at_the_end = 0, wrong = 0;
};

/// Is this the first touch, and is none none?
bool is_right(const RandomSteps::Step& step, const std::optional<Impact>& impact) {
    const test::MovingTriangle truth(step.ball, step.from, step.to);
    const long double radius = step.ball.radius, off = touch_tolerance * step.size();
    if (!impact) return !truth.comes_within(radius - off, 1);
    const long double t = impact->time, distance = truth.distance(t);
    if (!(t >= 0 && t <= 1 && distance <= radius + off)) return false;
    if (t > 0 && (distance < radius - off || truth.comes_within(radius - off, t))) return false;
    const auto corners = truth.at(t);
    test::Long3 point = test::Long3::Zero();
    for (std::size_t k = 0; k < 3; ++k) point += static_cast<long double>(impact->barycentric[k]) * corners[k];
    return (point - distance * impact->normal.cast<long double>()).norm() < off;
}

Outcome compare(FirstImpact find, int rounds) {
    RandomSteps steps;
    Outcome outcome;
    for (int round = 0; round < rounds; ++round) {
        const RandomSteps::Step step = steps.draw(round);
        const std::optional<Impact> impact = find(step.ball, step.from, step.to);
        if (impact) {
            ++outcome.impacts;
            outcome.at_once += impact->time == 0;
            outcome.at_the_end += impact->time > near_the_end;
        }
        outcome.wrong += !is_right(step, impact);
    }
    return outcome;
}

TEST(FirstImpact, IsThatOfAPlainSearchInAHundredThousandSteps) {
    const Outcome outcome = compare(first_impact, 100'000);
    EXPECT_EQ(outcome.wrong, 0);
    EXPECT_GT(outcome.impacts, 25'000);
    EXPECT_LT(outcome.impacts, 70'000);
    EXPECT_GT(outcome.at_the_end, 5'000);
    EXPECT_GT(outcome.at_once, 500);
}

/// Planted faults: impacts on one edge are lost, or those at the end of the step, or each is found a little late.
TEST(FirstImpact, IsCaughtWithoutAnEdge) {
    const FirstImpact faulty = [](const SweptBall& ball, const Corners& from, const Corners& to) {
        const auto impact = first_impact(ball, from, to);
        const bool lost = impact && impact->barycentric[2] == 0 && impact->barycentric[0] * impact->barycentric[1] != 0;
        return lost ? std::nullopt : impact;
    };
    EXPECT_GT(compare(faulty, 10'000).wrong, 100);
}

TEST(FirstImpact, IsCaughtWithoutTheEndOfTheStep) {
    const FirstImpact faulty = [](const SweptBall& ball, const Corners& from, const Corners& to) {
        const auto impact = first_impact(ball, from, to);
        return impact && impact->time > near_the_end ? std::nullopt : impact;
    };
    EXPECT_GT(compare(faulty, 10'000).wrong, 100);
}

TEST(FirstImpact, IsCaughtIfItIsLate) {
    const FirstImpact faulty = [](const SweptBall& ball, const Corners& from, const Corners& to) {
        auto impact = first_impact(ball, from, to);
        if (impact && impact->time > 0) impact->time = std::min(impact->time + Real(1e-2), Real(1));
        return impact;
    };
    EXPECT_GT(compare(faulty, 10'000).wrong, 500);
}

}  // namespace
}  // namespace drape
