// Balls that fall on solids, and balls that the keys lead against them.

#include <gmock/gmock.h>

#include <cmath>

#include "sim/small_scene.h"

namespace drape {
namespace {

constexpr Real size_of_ball = Real(0.1);

/// How far a ball under the keys may sink in [m].
constexpr Real sag = Real(1e-4);

/// A ball, and a cloth far from it.
Settings ball_alone(BallMotion motion, const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
    Settings settings = small_settings();
    settings.cloths[0].place = Vec3(0, 50, 0);
    BallSettings& ball = settings.balls[0];
    ball.radius = size_of_ball;
    ball.mass = Real(0.3);
    ball.motion = motion;
    ball.position = position;
    ball.velocity = velocity;
    settings.contact.restitution = Real(0.6);
    settings.ground = {.height = 0, .solid = false, .friction = settings.contact.friction, .restitution = Real(0.6)};
    settings.solver.sleep_speed = 0;
    return settings;
}

/// A box whose upper side is at height 0.
SolidSettings slab(Real thickness) {
    SolidSettings solid;
    solid.size = {4, thickness, 4};
    solid.position = {0, -thickness / 2, 0};
    return solid;
}

Settings on_slab(Settings settings, Real thickness = Real(0.2)) {
    settings.solids = {slab(thickness)};
    return settings;
}

/// The keys lead the ball by more than its size in a step.
void let_it_dart(Settings& settings) {
    settings.balls[0].speed = 100;
    settings.solver.dt = 1.0 / 60;
    settings.solver.integrator = IntegratorKind::BackwardEuler;
}

TEST(BallsOnSolids, ABallFallsBouncesAndRestsOnABoxAsOnTheGround) {
    for (const ResponseKind response : values_of<ResponseKind>()) {
        SCOPED_TRACE(name_of(response));
        Settings settings = ball_alone(BallMotion::Free, {0, size_of_ball + Real(0.5), 0}, {Real(0.2), 0, 0});
        settings.contact.response = response;
        Simulation on_box("box", on_slab(settings));
        settings.ground.solid = true;
        Simulation on_ground("ground", settings);
        for (int step = 0; step < 3000; ++step) {
            on_box.step(), on_ground.step();
            ASSERT_LT((on_box.balls()[0].centre - on_ground.balls()[0].centre).norm(), 1e-9) << step;
            ASSERT_LT((on_box.balls()[0].spin - on_ground.balls()[0].spin).norm(), 1e-6) << step;
        }
        EXPECT_GT(on_box.balls()[0].spin.norm(), 0.1) << "friction turns it";
    }
}

TEST(BallsOnSolids, ABallComesToRestOnACapsule) {
    constexpr Real top = Real(0.45);
    Settings settings = ball_alone(BallMotion::Free, {0, top + size_of_ball + Real(0.1), 0});
    settings.contact.restitution = 0;
    SolidSettings& capsule = settings.solids.emplace_back(slab(Real(0.2)));
    capsule.shape = SolidKind::Capsule;
    capsule.radius = Real(0.3);
    capsule.length = Real(0.5);
    Simulation simulation("rest", settings);
    make_steps(simulation, 1500);
    const Ball& ball = simulation.balls()[0];
    EXPECT_NEAR(ball.centre.y(), top + size_of_ball, 1e-4);
    EXPECT_LT(ball.velocity.norm(), 1e-6);
    EXPECT_LT(simulation.report().penetration, 1e-4);
}

TEST(BallsOnSolids, NoBallPassesAPlateHoweverFastAndThin) {
    // Within a long step, from these heights, it would end on the near side, in the plate, and on the far side
    for (const Real height : {Real(0.9), Real(0.8), Real(0.77), Real(0.5)}) {
        for (const double dt : {1.0 / 1024, 1.0 / 60}) {
            for (const Real turn : {Real(0), Real(35)}) {
                Settings settings = ball_alone(BallMotion::Free, {0, height, 0}, {0, -50, 0});
                settings.solver.dt = dt;
                settings.solver.integrator = IntegratorKind::BackwardEuler;
                settings.solids = {slab(Real(0.001))};
                settings.solids[0].axis = {0, 0, 1};
                settings.solids[0].angle = turn;
                Simulation simulation("plate", settings);
                make_steps(simulation, 1);
                for (int step = 0; step < 20; ++step) {
                    const Solid& plate = simulation.solids()[0];
                    const Vec3 seen = plate.orientation.conjugate() * (simulation.balls()[0].centre - plate.position);
                    ASSERT_GT(seen.y(), size_of_ball - 1e-4) << "from " << height << ", step " << step;
                    make_steps(simulation, 1);
                    if (std::abs(seen.x()) > 1 || std::abs(seen.z()) > 1) break;
                }
            }
        }
    }
}

TEST(BallsOnSolids, APlateOnAPathTakesABallAlong) {
    Settings settings = on_slab(ball_alone(BallMotion::Free, {0, Real(0.3), 0}), Real(0.001));
    settings.contact.restitution = 0;
    settings.solids[0].motion = SolidMotion::Path;
    settings.solids[0].path = {{0, Vec3(0, 0, 0)}, {Real(0.1), Vec3(0, 4, 0)}};
    settings.solver.dt = 1.0 / 60;
    settings.solver.integrator = IntegratorKind::BackwardEuler;
    Simulation simulation("lift", settings);
    make_steps(simulation, 6);
    EXPECT_GT(simulation.balls()[0].centre.y(), simulation.solids()[0].position.y());
}

TEST(BallsOnSolids, TheKeysLeadABallOntoThemAndAlongThem) {
    // Heights at which sums with the radius are rounded, and one at which they are not
    for (const Real height : {Real(0), Real(0.7), Real(1.3)}) {
        Settings settings = on_slab(ball_alone(BallMotion::Keys, {0, height + Real(0.5), 0}));
        settings.solids[0].position.y() += height;
        settings.balls[0].speed = 2;
        Simulation simulation("keys", settings);
        const Ball& ball = simulation.balls()[0];
        send(simulation, "steer 0 -1 0");
        const Real lowest = height + size_of_ball + 2 * settings.contact.thickness;
        for (int step = 0; step < 1000; ++step) {
            simulation.step();
            ASSERT_GT(ball.centre.y(), lowest - sag);
        }
        EXPECT_NEAR(ball.centre.y(), lowest, sag);
        EXPECT_NEAR(ball.velocity.y(), 0, 1e-9);
        send(simulation, "steer 0.8 -0.6 0");
        make_steps(simulation, 500);
        EXPECT_GT(ball.centre.x(), 0.3) << "it slides at " << height;
        EXPECT_GT(ball.centre.y(), lowest - sag);
    }
}

TEST(BallsOnSolids, TheKeysLeadABallIntoNoCornerHoweverFast) {
    Settings settings = on_slab(ball_alone(BallMotion::Keys, {0, Real(0.5), 0}));
    for (const Vec3& wall : {Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
        SolidSettings& solid = settings.solids.emplace_back(slab(Real(0.2)));
        solid.size = {4, 4, 4};
        solid.size -= Real(3.999) * wall;
        solid.position = wall;
    }
    let_it_dart(settings);
    Simulation simulation("corner", settings);
    for (const char* way : {"steer 0.6 -0.5 0.6", "steer 0.7 0 0.7", "steer 0 -0.7 0.7"}) {
        send(simulation, way);
        for (int step = 0; step < 40; ++step) {
            simulation.step();
            for (const Solid& solid : simulation.solids()) {
                ASSERT_GT(solid.distance(simulation.balls()[0].centre), size_of_ball) << way << " " << step;
            }
            ASSERT_LT(simulation.balls()[0].centre.x(), 1);
            ASSERT_LT(simulation.balls()[0].centre.z(), 1);
            ASSERT_GT(simulation.balls()[0].centre.y(), 0);
        }
    }
}

/// Between two walls, where there is less room than it needs, it does not stay for ever.
TEST(BallsOnSolids, TheKeysLeadABallOutOfWhereItHasNoRoomButNoDeeper) {
    constexpr Real beside = (Real(1.8) * size_of_ball + Real(0.2)) / 2;
    Settings settings = ball_alone(BallMotion::Keys, {0, Real(0.9), 0});
    settings.balls[0].speed = 1;
    for (const Real side : {beside, -beside}) {
        SolidSettings& box = settings.solids.emplace_back(slab(1));
        box.size = {Real(0.2), 2, 4}, box.position = {side, 0, 0};
    }
    Simulation simulation("slot", settings);
    const Vec3 start = simulation.balls()[0].centre;
    for (const char* deeper : {"steer 0.8 0.6 0", "steer -0.8 0.6 0"}) {
        send(simulation, deeper);
        make_steps(simulation, 100);
        EXPECT_NEAR(simulation.balls()[0].centre.x(), start.x(), sag) << deeper;
    }
    send(simulation, "steer 0 1 0");
    make_steps(simulation, 2000);
    EXPECT_GT((simulation.balls()[0].centre - start).norm(), 1);
}

TEST(BallsOnSolids, TheKeysLeadABallNoDeeperIntoANarrowGroove) {
    Settings settings = ball_alone(BallMotion::Keys, {0, Real(0.2), 0});
    settings.balls[0].speed = 1;
    for (const Real side : {Real(0.3), Real(-0.3)}) {
        SolidSettings& wall = settings.solids.emplace_back(slab(1));
        wall.size = {Real(0.2), 4, 4}, wall.position = {side, 0, 0};
        wall.axis = Vec3(0, 0, 1), wall.angle = side > 0 ? Real(-10) : Real(10);
    }
    Simulation simulation("groove", settings);
    send(simulation, "steer 0 -1 0");
    run_until(simulation, 4);
    const Vec3 centre = simulation.balls()[0].centre;
    for (const Solid& wall : simulation.solids()) {
        EXPECT_NEAR(wall.distance(centre), size_of_ball + 2 * settings.contact.thickness, 2 * sag) << centre;
    }
}

/// A ball on the ground may leave a box that closes on it.
TEST(BallsOnSolids, AWedgedBallLeavesAClosingPress) {
    Settings settings = ball_alone(BallMotion::Keys, {0, size_of_ball + Real(0.005), 0});
    settings.ground.solid = true;
    SolidSettings& press = settings.solids.emplace_back(slab(1));
    press.size = {2, Real(0.2), 4};
    press.motion = SolidMotion::Path;
    press.path = {{0, Vec3(0, Real(0.4), 0)}, {10, Vec3(0, Real(0.2), 0)}};
    settings.balls[0].speed = 1;
    Simulation simulation("press", settings);
    run_until(simulation, 6);  // it is in the ball by then
    ASSERT_LT(simulation.solids()[0].distance(simulation.balls()[0].centre), Real(0.09));
    EXPECT_GE(simulation.balls()[0].centre.y(), size_of_ball);
    send(simulation, "steer 1 0 0");
    make_steps(simulation, 2000);
    EXPECT_GT(simulation.balls()[0].centre.x(), 1);
}

/// Whichever is first in the scene, and under every response.
TEST(BallsOnSolids, TheKeysLeadABallIntoNoBallThatStandsStill) {
    for (int response = 0; response < 4; ++response) {
        for (const std::size_t led : {0U, 1U}) {
            Settings settings = ball_alone(BallMotion::Keys, {0, 0, 0});
            settings.contact.response = static_cast<ResponseKind>(response);
            settings.balls.push_back(settings.balls[0]);
            settings.balls[1 - led].motion = BallMotion::Still;
            settings.balls[1 - led].position = {1, 0, 0};
            Simulation simulation("ball", settings);
            send(simulation, "steer 1 0 0");
            run_until(simulation, 2);
            const Real expected = 1 - 2 * (size_of_ball + settings.contact.thickness);
            EXPECT_NEAR(simulation.balls()[led].centre.x(), expected, sag) << response;
            EXPECT_EQ(simulation.balls()[1 - led].centre, settings.balls[1 - led].position);
            EXPECT_EQ(simulation.report().penetration, 0);
        }
    }
}

TEST(BallsOnSolids, AMovingPlateCarriesABallUnderTheKeys) {
    Settings settings = on_slab(ball_alone(BallMotion::Keys, {0, Real(0.2), 0}));
    settings.solids[0].motion = SolidMotion::Path;
    settings.solids[0].path = {{0, Vec3(0, Real(-0.1), 0)}, {1, Vec3(0, Real(0.9), 0)}};
    Simulation simulation("lift", settings);
    run_until(simulation, 0.5);
    const Solid& plate = simulation.solids()[0];
    const Ball& ball = simulation.balls()[0];
    EXPECT_NEAR(plate.distance(ball.centre), size_of_ball + 2 * settings.contact.thickness, sag);
    EXPECT_NEAR(ball.velocity.y(), plate.velocity.y(), 0.1);
}

/// The step that would reach the ground passes the plate first.
TEST(BallsOnSolids, TheKeysLeadABallThroughNoPlateAboveTheGround) {
    Settings settings = on_slab(ball_alone(BallMotion::Keys, {0, Real(0.15), 0}), Real(0.001));
    settings.ground = {.height = Real(-0.25), .solid = true, .friction = 0, .restitution = 0};
    let_it_dart(settings);
    Simulation simulation("plate", settings);
    send(simulation, "steer 0 -1 0");
    make_steps(simulation, 20);
    EXPECT_NEAR(simulation.balls()[0].centre.y(), size_of_ball + 2 * settings.contact.thickness, sag);
}

}  // namespace
}  // namespace drape
