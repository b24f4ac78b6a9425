// Balls that gravity and contact move: in the shipped scenes, and against exact formulas.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "sim/small_scene.h"

namespace drape {
namespace {

constexpr Real gravity = Real(9.81);

BallSettings free_ball(Real radius, Real mass, const Vec3& position, const Vec3& velocity) {
    BallSettings ball;
    ball.radius = radius;
    ball.mass = mass;
    ball.position = position;
    ball.velocity = velocity;
    ball.motion = BallMotion::Free;
    return ball;
}

/// Balls on solid ground at y = 0, far from the cloth.
Settings balls_alone(const std::vector<BallSettings>& balls) {
    Settings settings = small_settings();
    settings.cloths[0].place = Vec3(0, 50, 0);
    settings.balls = balls;
    settings.ground = {.height = 0};
    settings.solver.sleep_speed = 0;
    return settings;
}

/// The same in steps of 1/60 s, by a method under which they fall without error.
Settings in_long_steps(const std::vector<BallSettings>& balls, ResponseKind response) {
    Settings settings = balls_alone(balls);
    settings.contact.response = response;
    settings.solver.integrator = IntegratorKind::ImplicitMidpoint;
    settings.solver.dt = 1.0 / 60;
    return settings;
}

Vec3 momentum(const Simulation& simulation) {
    Vec3 sum = Vec3::Zero();
    for (const Ball& ball : simulation.balls()) sum += ball.velocity / ball.inverse_mass;
    return sum;
}

TEST(FreeBalls, ThatCollideKeepTheirMomentumButForTheFall) {
    Settings settings = balls_alone({free_ball(Real(0.1), Real(0.2), {-1, 30, 0}, {4, 0, 0}),
                                     free_ball(Real(0.2), Real(1.5), {1, Real(30.05), Real(0.1)}, {-3, 0, 0})});
    settings.contact.restitution = Real(0.5);
    Simulation simulation("drop", std::move(settings));
    const Vec3 before = momentum(simulation);
    const Vec3 parting = simulation.balls()[1].velocity - simulation.balls()[0].velocity;
    run_until(simulation, 0.5);
    const Vec3 fall(0, -Real(1.7) * gravity * Real(0.5), 0);
    EXPECT_LT((momentum(simulation) - before - fall).norm(), 1e-10 * before.norm());
    const Vec3 parted = simulation.balls()[1].velocity - simulation.balls()[0].velocity;
    EXPECT_LT(parting.x(), 0);
    EXPECT_GT(parted.x(), 1) << "they have met, and thrown each other back";
    EXPECT_GT(simulation.balls()[0].spin.norm(), 1) << "and rubbed";
}

/// Each moves by 42 times its diameter in a step. They do not meet head-on, and roll off each other.
TEST(FreeBalls, MeetHoweverFastTheyFly) {
    for (const auto response : {ResponseKind::Projection, ResponseKind::Impulse, ResponseKind::Hybrid}) {
        Settings settings = in_long_steps({free_ball(Real(0.02), Real(0.05), {-3, 1, 0}, {100, 0, 0}),
                                           free_ball(Real(0.02), Real(0.05), {3, 1, Real(0.005)}, {-100, 0, 0})},
                                          response);
        settings.solver.integrator = IntegratorKind::BackwardEuler;
        Simulation simulation("drop", settings);
        run_until(simulation, 0.1);
        for (const Ball& ball : simulation.balls()) {
            EXPECT_LT(std::abs(ball.centre.x()), 0.5) << name_of(response);
            EXPECT_LT(ball.velocity.norm(), 20) << name_of(response);
        }
    }
}

/// The struck ball goes where the line of centres pointed when they met, though both fly on within the step.
TEST(FreeBalls, ThrowEachOtherInTheDirectionInWhichTheyMeet) {
    const Real radius = Real(0.02), aside = Real(0.02), speed = 20;
    for (const auto response : {ResponseKind::Projection, ResponseKind::Impulse}) {
        Settings settings = in_long_steps({free_ball(radius, Real(0.05), {Real(-0.1), 1, 0}, {speed, 0, 0}),
                                           free_ball(radius, Real(0.05), {0, 1, aside}, Vec3::Zero())},
                                          response);
        settings.world.gravity = 0;
        settings.contact.friction = 0;
        settings.solver.dt = 1e-3;
        Simulation simulation("drop", settings);
        run_until(simulation, 0.02);
        const Vec3 struck = simulation.balls()[1].velocity;
        EXPECT_GT(struck.norm(), speed / 4) << name_of(response);
        EXPECT_NEAR(struck.z() / struck.norm(), aside / (2 * radius), 0.02) << name_of(response);
    }
}

/// A ball that falls 0.5 m in steps of 1/60 s, until its first step upwards or at rest.
Ball fall_in_long_steps(ResponseKind response, Real restitution) {
    const Real radius = Real(0.1);
    Settings settings =
        in_long_steps({free_ball(radius, Real(0.4), {0, radius + Real(0.5), 0}, Vec3::Zero())}, response);
    settings.ground.restitution = restitution;
    settings.contact.longest_step = 1;
    Simulation simulation("drop", settings);
    do simulation.step();
    while (simulation.balls()[0].velocity.y() < 0 && simulation.report().time < 1);
    EXPECT_EQ(simulation.report().substeps, 1);
    return simulation.balls()[0];
}

/// In one such step gravity adds 5 % to the speed of the impact; an impulse is that of its own time.
TEST(FreeBalls, BounceInLongStepsToTheHeightOfTheRestitutionUnderImpulses) {
    for (const auto response : {ResponseKind::Impulse, ResponseKind::Hybrid}) {
        const Ball bounced = fall_in_long_steps(response, Real(0.6));
        const Real speed = bounced.velocity.y();
        EXPECT_GT(speed, 1);
        const Real reached = bounced.centre.y() - bounced.radius + speed * speed / (2 * gravity);
        EXPECT_NEAR(reached, 0.36 * 0.5, 1e-4) << name_of(response);
        const Ball stopped = fall_in_long_steps(response, 0);
        EXPECT_EQ(stopped.velocity.y(), 0) << name_of(response);
        EXPECT_NEAR(stopped.centre.y(), stopped.radius, 1e-4) << name_of(response);
    }
}

/// Onto a ball that is held, onto a box, and onto the ground.
TEST(FreeBalls, AreNotThrownHigherThanTheyFellFromByPenaltiesInLongSteps) {
    constexpr std::array<Real, 3> supports{1, 1, 0};  // m
    for (const auto response : {ResponseKind::Penalty, ResponseKind::Hybrid}) {
        BallSettings held;
        held.radius = Real(0.5);
        held.position = Vec3(-2, Real(0.5), 0);
        Settings settings = in_long_steps({held}, response);
        for (const Real x : {-2, 0, 2}) {
            settings.balls.push_back(free_ball(Real(0.1), Real(0.4), {x, Real(1.6), 0}, Vec3::Zero()));
        }
        SolidSettings box;
        box.size = Vec3(1, 1, 1);
        box.position = Vec3(0, Real(0.5), 0);
        settings.solids.push_back(box);
        settings.contact.stiffness = 5e4;
        Simulation simulation("drop", settings);
        std::array<Real, 3> lowest{2, 2, 2};
        for (int step = 0; step < 60; ++step) {
            simulation.step();
            for (std::size_t b = 0; b < 3; ++b) {
                const Real y = simulation.balls()[b + 1].centre.y();
                lowest[b] = std::min(lowest[b], y);
                EXPECT_LT(y, 1.601) << name_of(response) << ", ball " << b;
            }
        }
        for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(lowest[b], supports[b] + Real(0.1), 0.01) << b;
    }
}

class BallOnLyingCloth : public testing::TestWithParam<IntegratorKind> {};

/// Cloth between a heavy ball and the ground is pushed from both sides.
TEST_P(BallOnLyingCloth, GivesItNoEnergyFromNowhere) {
    Settings settings = load_scene("drop");
    settings.cloths[0].particles = {16, 16};
    settings.cloths[0].place = Vec3(0, Real(0.005), 0);
    settings.balls = {free_ball(Real(0.15), 1, {Real(-0.3), Real(0.25), 0}, {5, -4, 0})};
    settings.solver.integrator = GetParam();
    settings.solver.dt = 4e-3;
    Simulation simulation("drop", std::move(settings));
    run_until(simulation, 0.5);
    EXPECT_GT(simulation.report().contacts, 0);
    EXPECT_EQ(simulation.report().energy_gain_step, 0) << simulation.report().energy_excess << " J";
}

INSTANTIATE_TEST_SUITE_P(OneMethod, BallOnLyingCloth, testing::Values(IntegratorKind::BackwardEuler), name_of_param);
INSTANTIATE_TEST_SUITE_P(Nightly, BallOnLyingCloth,
                         testing::Values(IntegratorKind::Bdf2, IntegratorKind::ImplicitMidpoint, IntegratorKind::Xpbd),
                         name_of_param);

/// Sliding brings a solid sphere to 5/7 of its speed, whatever the friction.
TEST(FreeBalls, RollOnTheGroundByDistanceOverRadius) {
    const Real radius = Real(0.15);
    Simulation simulation("drop", balls_alone({free_ball(radius, Real(0.4), {0, radius, 0}, {Real(0.7), 0, 0})}));
    run_until(simulation, 0.5);
    const Ball start = simulation.balls()[0];
    EXPECT_NEAR(start.velocity.x(), 0.5, 1e-3);
    run_until(simulation, 1);
    const Ball& end = simulation.balls()[0];
    const Vec3 way = end.centre - start.centre;
    const Eigen::AngleAxis<Real> turn(end.orientation * start.orientation.conjugate());
    EXPECT_NEAR(way.x(), 0.25, 1e-3);
    EXPECT_NEAR(turn.angle(), way.x() / radius, 1e-4);
    EXPECT_NEAR(turn.axis().z(), -1, 1e-9) << "forwards";
    EXPECT_NEAR(end.centre.y(), radius, 1e-4);
}

/// Resistance slows a rolling sphere by 5/7 of coefficient times gravity.
TEST(FreeBalls, StopAfterTheWayThatRollingResistanceLeavesThem) {
    const Real radius = Real(0.1), rolling = Real(0.05);
    Settings settings = balls_alone({free_ball(radius, Real(0.3), {0, radius, 0}, {0, 0, Real(0.8)})});
    settings.ground.rolling = rolling;
    Simulation simulation("drop", std::move(settings));
    run_until(simulation, 0.4);
    const Ball start = simulation.balls()[0];
    const Real slowing = rolling * gravity * 5 / 7, speed = start.velocity.z();
    ASSERT_GT(speed, 0.3);
    run_until(simulation, 4.4);
    const Ball& end = simulation.balls()[0];
    EXPECT_NEAR(end.centre.z() - start.centre.z(), speed * speed / (2 * slowing), 0.005);
    EXPECT_LT(end.velocity.norm(), 1e-6);
    EXPECT_LT(end.spin.norm(), 1e-6);
}

Real lowest(const Simulation& simulation) {
    Real least = simulation.cloths()[0].state.x.col(1).minCoeff();
    for (const Ball& ball : simulation.balls()) least = std::min(least, ball.centre.y() - ball.radius);
    return least;
}

class SceneOnTheGround : public testing::TestWithParam<const char*> {};

TEST_P(SceneOnTheGround, ComesToRestOnItAndNothingFallsBelow) {
    Simulation simulation(GetParam(), load_scene(GetParam()));
    for (int step = 0; step < 32'000 && !simulation.report().asleep; ++step) {
        simulation.step();
        ASSERT_GT(lowest(simulation), -1e-3) << "at " << simulation.report().time << " s";
    }
    EXPECT_TRUE(simulation.report().asleep);
    for (const Ball& ball : simulation.balls()) EXPECT_NEAR(ball.centre.y(), ball.radius, 1e-3);
    EXPECT_LT(simulation.cloths()[0].state.x.col(1).minCoeff(), 0.01) << "the cloth touches it";
}

INSTANTIATE_TEST_SUITE_P(Long, SceneOnTheGround, testing::Values("three_balls", "slide"), name_of_param);

}  // namespace
}  // namespace drape
