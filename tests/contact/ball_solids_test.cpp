// A ball that nothing pushes stops at solids, slides along them, and stays where it was if they leave it no room.

#include "drape/contact/detection.h"

#include <gtest/gtest.h>

#include "contact/solid_at.h"

namespace drape {
namespace {

constexpr Real led_radius = Real(0.1), led_step = Real(0.01);

/// A ball at the end of its way through a substep.
Ball steered_ball(const Vec3& start, const Vec3& end) {
    Ball ball;
    ball.radius = led_radius;
    ball.centre = end;
    ball.moved = end - start;
    ball.velocity = ball.moved / led_step;
    return ball;
}

/// Two boxes whose upper sides are at height 0, with a groove between them.
std::vector<Solid> groove(Real width) {
    const auto box = make_box(Vec3(1, 1, 4));
    return {test::solid_at(box, Vec3(-(1 + width) / 2, Real(-0.5), 0)),
            test::solid_at(box, Vec3((1 + width) / 2, Real(-0.5), 0))};
}

std::vector<Body> bodies_of(const std::vector<Solid>& solids) {
    std::vector<Body> bodies;
    for (const Solid& solid : solids) bodies.push_back(body_of(solid, {}));
    return bodies;
}

/// How far a ball is from the nearest of some solids; less than zero inside [m].
Real gap_to(const std::vector<Solid>& solids, const Ball& ball) {
    Real gap = std::numeric_limits<Real>::infinity();
    for (const Solid& solid : solids) gap = std::min(gap, solid.distance(ball.centre) - ball.radius);
    return gap;
}

TEST(StayOutside, LeavesABallWhereItWasThatSolidsGiveNoRoom) {
    // Whatever one of the boxes pushes out, the other pushes back
    const std::vector<Solid> solids = groove(Real(1.9) * led_radius);
    for (const Real depth : {Real(0.05), Real(0.2), Real(0.4)}) {
        const Vec3 start(0, Real(0.2), 0);
        Ball ball = steered_ball(start, Vec3(Real(0.001), -depth, 0));
        stay_outside(bodies_of(solids), ball.centre - ball.moved, 0, ball);
        EXPECT_LT((ball.centre - start).norm(), 1e-15) << depth;
        EXPECT_EQ(ball.velocity, Vec3::Zero()) << depth;
        EXPECT_EQ(ball.moved, Vec3::Zero()) << depth;
    }
}

TEST(StayOutside, LetsABallIntoAGrooveThatIsWideEnough) {
    const std::vector<Solid> solids = groove(Real(2.1) * led_radius);
    const Vec3 end(0, Real(-0.3), 0);
    Ball ball = steered_ball(Vec3(0, Real(0.2), 0), end);
    const Vec3 velocity = ball.velocity;
    stay_outside(bodies_of(solids), ball.centre - ball.moved, 0, ball);
    EXPECT_EQ(ball.centre, end);
    EXPECT_EQ(ball.velocity, velocity);
}

TEST(StayOutside, LetsABallSlideIntoACorner) {
    // A floor and two walls: three planes, one after the other
    std::vector<Solid> solids;
    const auto box = make_box(Vec3(2, 2, 2));
    for (const Vec3& place : {Vec3(0, -1, 0), Vec3(Real(-1.3), 0, 0), Vec3(0, 0, Real(-1.3))}) {
        solids.push_back(test::solid_at(box, place));
    }
    Ball ball = steered_ball(Vec3(0, Real(0.3), 0), Vec3(Real(-0.4), Real(-0.2), Real(-0.5)));
    stay_outside(bodies_of(solids), ball.centre - ball.moved, 0, ball);
    EXPECT_GT(gap_to(solids, ball), -1e-5);
    EXPECT_NEAR((ball.centre - Vec3(Real(-0.2), led_radius, Real(-0.2))).norm(), 0, 1e-5);
    EXPECT_GE(ball.velocity.minCoeff(), 0);
}

TEST(StayOutside, LeavesABallAloneThatOnlyTouches) {
    const std::vector<Solid> solids{test::solid_at(make_box(Vec3(2, 1, 2)), Vec3(0, Real(-0.5), 0))};
    const Vec3 end(Real(0.01), led_radius, 0);
    Ball ball = steered_ball(Vec3(0, led_radius, 0), end);
    const Vec3 velocity = ball.velocity;
    stay_outside(bodies_of(solids), ball.centre - ball.moved, 0, ball);
    EXPECT_EQ(ball.centre, end);
    EXPECT_EQ(ball.velocity, velocity);
}

/// A pin, say, has put it back a little and taken all of its motion.
TEST(StayOutside, FollowsTheWholePathWhateverHasShortenedIt) {
    const std::vector<Solid> solids{test::solid_at(make_box(Vec3(4, Real(0.001), 4)), Vec3::Zero())};
    const Vec3 start(0, Real(0.5), 0);
    Ball ball = steered_ball(start, Vec3(0, Real(-0.5), 0));
    ball.centre.y() += Real(0.1);
    ball.velocity.setZero();
    ball.moved.setZero();
    stay_outside(bodies_of(solids), start, 0, ball);
    EXPECT_NEAR(ball.centre.y(), led_radius + Real(0.0005), 1e-5);
    EXPECT_LT((ball.centre - ball.moved - start).norm(), 1e-15) << "planes of contacts are those of its start";
}

}  // namespace
}  // namespace drape
