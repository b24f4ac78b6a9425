#include <gtest/gtest.h>

#include "sim/small_scene.h"

namespace drape {
namespace {

const std::string open_path = "ball.path=[[0.5, 0, 0, 0], [1, 1, 0, 0], [2, 1, 2, 0]]";
const std::string closed_path = "ball.path=[[0, 0, 0, 0], [0.5, 1, 0, 0], [1, 1, 1, 0], [1.5, 0, 0, 0]]";

/// A ball far from the cloth on a path, after some time.
Ball ball_after(const std::string& path, double seconds) {
    Simulation simulation = small_simulation({"ball.motion=path", path, "cloth.origin=0,-50,0"});
    make_steps(simulation, static_cast<int>(1024 * seconds));
    return simulation.balls()[0];
}

TEST(BallOnAPath, PassesItsPointsAtTheirTimes) {
    EXPECT_EQ(ball_after(open_path, 0).centre, Vec3(0, 0, 0));
    EXPECT_EQ(ball_after(open_path, 0.25).centre, Vec3(0, 0, 0)) << "it waits for the path to begin";
    EXPECT_EQ(ball_after(open_path, 0.25).velocity, Vec3(0, 0, 0));
    EXPECT_LT((ball_after(open_path, 1).centre - Vec3(1, 0, 0)).norm(), 1e-12);
    EXPECT_EQ(ball_after(open_path, 3).centre, Vec3(1, 2, 0)) << "it rests where the path ends";
    EXPECT_EQ(ball_after(open_path, 3).velocity, Vec3(0, 0, 0));
}

TEST(BallOnAPath, RepeatsAClosedOne) {
    for (const double time : {0.25, 0.75, 1.25, 1.375}) {
        const Ball once = ball_after(closed_path, time), later = ball_after(closed_path, time + 3);
        EXPECT_LT((once.centre - later.centre).norm(), 1e-9) << time;
        EXPECT_LT((once.velocity - later.velocity).norm(), 1e-6) << time;
        EXPECT_GT(once.velocity.norm(), 0.1) << time;
    }
    EXPECT_NEAR(ball_after(closed_path, 1.5).velocity.norm(), 1, 0.05) << "it does not stop where the path closes";
    EXPECT_LT((ball_after(closed_path, 2).centre - Vec3(1, 0, 0)).norm(), 1e-9);
}

TEST(BallOnAPath, HasTheVelocityOfItsMotionAndNoLeaps) {
    Simulation simulation = small_simulation({"ball.motion=path", closed_path, "cloth.origin=0,-50,0"});
    Ball before = simulation.balls()[0];
    for (int i = 0; i < 4000; ++i) {
        simulation.step();
        const Ball& ball = simulation.balls()[0];
        const Vec3 moved = ball.centre - before.centre;
        ASSERT_LT((moved - ball.velocity / 1024).norm(), 1e-12) << "step " << i;
        ASSERT_LT(moved.norm(), 5.0 / 1024) << "step " << i;
        ASSERT_LT((ball.velocity - before.velocity).norm(), i > 1 ? 0.1 : 5) << "step " << i;
        before = ball;
    }
}

TEST(BallOnAPath, IsNoBulletWhenACommandPutsItThere) {
    Simulation simulation = small_simulation();
    simulation.apply(command::Set{closed_path});
    make_steps(simulation, 10);
    simulation.apply(command::Set{"ball.motion=path"});
    simulation.step();
    EXPECT_LT(simulation.balls()[0].velocity.norm(), 5);
    simulation.apply(command::Set{"ball.position=9,9,9"});
    simulation.step();
    EXPECT_LT(simulation.balls()[0].velocity.norm(), 5);
    EXPECT_LT(simulation.balls()[0].centre.norm(), 2) << "the path has it back";
}

}  // namespace
}  // namespace drape
