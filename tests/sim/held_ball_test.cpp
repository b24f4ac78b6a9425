// A ball in the hand: led, thrown and stopped by cloth.

#include <gmock/gmock.h>

#include <algorithm>

#include "drape/contact/detection.h"
#include "sim/small_scene.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const Ball& ball_of(const Simulation& simulation) { return simulation.balls()[0]; }

/// The small scene with its ball far from the cloth.
Simulation ball_alone(const std::string& motion) {
    return small_simulation({"ball.position=0,-5,0", "ball.motion=" + motion});
}

TEST(HeldBall, IsLedToItsTargetAndHardlyBeyond) {
    for (const char* motion : {"free", "keys"}) {
        Simulation simulation = ball_alone(motion);
        send(simulation, "hold 0");
        EXPECT_TRUE(simulation.view().held);
        make_steps(simulation, 200);
        EXPECT_EQ(ball_of(simulation).centre, Vec3(0, -5, 0)) << motion << ": held where it was taken";
        send(simulation, "drag 1 -5 0");
        Real farthest = 0;
        for (int step = 0; step < 1024; ++step) {
            simulation.step();
            farthest = std::max(farthest, ball_of(simulation).centre.x());
            EXPECT_LE(ball_of(simulation).velocity.norm(), 3) << "m/s, as fast as a hand";
        }
        EXPECT_LT((ball_of(simulation).centre - Vec3(1, -5, 0)).norm(), 1e-3) << motion;
        EXPECT_LT(farthest, 1.02) << motion;
    }
}

TEST(HeldBall, FliesOnAsItIsLetGoOrIsGivenBackToTheKeys) {
    Simulation free = ball_alone("free"), keys = ball_alone("keys");
    for (Simulation* simulation : {&free, &keys}) {
        send(*simulation, "hold 0");
        send(*simulation, "drag 9 -5 0");
        make_steps(*simulation, 200);
        send(*simulation, "release");
        EXPECT_FALSE(simulation->view().held);
    }
    const Ball thrown = ball_of(free);
    EXPECT_GT(thrown.velocity.x(), 2.9);
    make_steps(free, 1024);
    EXPECT_NEAR(ball_of(free).velocity.x(), thrown.velocity.x(), 1e-12);
    EXPECT_NEAR(ball_of(free).velocity.y(), -9.81, 1e-6) << "it falls";
    make_steps(keys, 1024);
    EXPECT_LT(ball_of(keys).velocity.norm(), 1e-4) << "no key is down";
    send(keys, "steer 0 1 0");
    make_steps(keys, 1024);
    EXPECT_GT(ball_of(keys).velocity.y(), 0.5);
}

TEST(HeldBall, IsThrownOutOfTheHand) {
    Simulation simulation = ball_alone("free");
    send(simulation, "hold 0");
    send(simulation, "throw 0 -5 0 0 0 -6");
    EXPECT_FALSE(simulation.view().held);
    send(simulation, "drag 0 -5 0");
    make_steps(simulation, 200);
    EXPECT_NEAR(ball_of(simulation).velocity.z(), -6, 1e-9);
}

TEST(HeldBall, IsNoneThatIsOnAPathOrStill) {
    for (const char* motion : {"ball.motion=still", "ball.path=0,0,0,0,1,0,0,0.1"}) {
        Simulation simulation = small_simulation(), other = small_simulation();
        for (Simulation* one : {&simulation, &other}) {
            send(*one, std::string("set ") + motion);
            if (motion[5] == 'p') send(*one, "set ball.motion=path");
        }
        send(simulation, "hold 0");
        send(simulation, "drag 2 2 2");
        for (Simulation* one : {&simulation, &other}) make_steps(*one, 200);
        EXPECT_EQ(simulation.hash(), other.hash()) << motion;
    }
    Simulation none = shipped_simulation("hang");
    EXPECT_THAT(test::input_error_of([&] { send(none, "hold 0"); }), HasSubstr("hold: ball 0: this scene has none"));
    Simulation one = small_simulation();
    EXPECT_THAT(test::input_error_of([&] { send(one, "hold 1"); }), HasSubstr("hold: ball 1: allowed 0 to 0"));
}

/// One thing at a time is in the hand.
TEST(HeldBall, IsLetGoForAParticleAndTakenInItsPlace) {
    Simulation simulation = small_simulation();
    send(simulation, "grab 0 75");
    send(simulation, "hold 0");
    EXPECT_FALSE(simulation.cloths()[0].model.pinned(75));
    EXPECT_EQ(simulation.view().steered_ball, 0) << "the ring is about it";
    send(simulation, "grab 0 75");
    EXPECT_TRUE(simulation.cloths()[0].model.pinned(75));
    EXPECT_EQ(simulation.view().steered_ball, -1);
}

/// The deepest that cloth is in the ball [m].
Real depth(const Simulation& simulation) {
    const Cloth& cloth = simulation.cloths()[0];
    return deepest_penetration(cloth.model.grid, cloth.state.x, simulation.balls(), 0);
}

/// Down through the middle as fast as a hand can, which then presses on; and out again.
TEST(HeldBall, IsStoppedByClothThatPinsHold) {
    for (const std::string motion : {"free", "keys"}) {
        for (const bool long_steps : {false, true}) {
            SCOPED_TRACE(motion + (long_steps ? " in long steps" : ""));
            std::vector<std::string> changes{"ball.motion=" + motion};
            if (long_steps) changes.insert(changes.end(), {"integrator=backward_euler", "dt=0.016666666666666666"});
            Simulation simulation = shipped_simulation("trampoline", changes);
            send(simulation, "hold 0");
            send(simulation, "drag 0.03 -2 0.02");
            Real deepest = 0;
            run_until(simulation, 0.5, [&] { deepest = std::max(deepest, depth(simulation)); });
            EXPECT_GT(simulation.report().contacts, 0);
            EXPECT_LT(deepest, long_steps ? 3e-3 : 1e-4) << "m";
            EXPECT_GT(ball_of(simulation).centre.y(), simulation.cloths()[0].state.x.col(1).minCoeff()) << "on it";
            EXPECT_LT(ball_of(simulation).velocity.norm(), 0.1) << "m/s";
            send(simulation, "drag 0.03 0.9 0.02");
            run_until(simulation, 1);
            EXPECT_NEAR(ball_of(simulation).centre.y(), 0.9, 1e-3);
            EXPECT_EQ(simulation.report().energy_gain_step, 0);
            EXPECT_THAT(simulation.run_warning(), IsEmpty());
        }
    }
}

}  // namespace
}  // namespace drape
