#include <gtest/gtest.h>

#include <cmath>

#include "sim/small_scene.h"

namespace drape {
namespace {

/// A cloth in free fall, and a free ball far below it.
Simulation falling(const std::vector<std::string>& assignments) {
    std::vector<std::string> all{
        "pinned=none",        "drag=0",        "ball.motion=free", "ball.position=0,-9,0", "ball.velocity=0,0,0",
        "ground.solid=false", "sleep_speed=0", "dt=2.5e-4",        "ledger=true"};
    all.insert(all.end(), assignments.begin(), assignments.end());
    return small_simulation(all);
}

void expect_speed(const Simulation& simulation, double speed) {
    const Points& v = simulation.cloths()[0].state.v;
    EXPECT_NEAR(v.col(1).minCoeff(), -speed, 1e-9);
    EXPECT_NEAR(v.col(1).maxCoeff(), -speed, 1e-9);
    EXPECT_NEAR(simulation.balls()[0].velocity[1], -speed, 1e-9);
}

TEST(Gravity, OfTheSceneMovesClothAndFreeBalls) {
    Simulation earth = falling({}), simulation = falling({"world.gravity=3.7"});
    make_steps(earth, 400), make_steps(simulation, 400);
    expect_speed(earth, 9.81 * 0.1);
    expect_speed(simulation, 3.7 * 0.1);
    send(simulation, "set world.gravity=1.6");
    make_steps(simulation, 400);
    expect_speed(simulation, 3.7 * 0.1 + 1.6 * 0.1);
    send(simulation, "reset");
    make_steps(simulation, 400);
    expect_speed(simulation, 1.6 * 0.1);
    EXPECT_EQ(simulation.report().energy_gain_step, 0);
}

/// As of a cloth that is made heavier, what the change gives is the hand's.
TEST(Gravity, ThatChangesKeepsTheEnergyBalance) {
    Simulation simulation = falling({"integrator=rk4"});
    make_steps(simulation, 400);
    send(simulation, "set world.gravity=3");
    make_steps(simulation, 400);
    const EnergyBalance balance = simulation.view().report->balance;
    EXPECT_GT(std::abs(balance.hand), 1e-3);
    EXPECT_LT(std::abs(balance.integrator), 1e-6);
}

TEST(Gravity, OfNoneLeavesAllWhereItIs) {
    Simulation simulation = falling({"world.gravity=0", "wind.velocity=0,0,0"});
    make_steps(simulation, 400);
    expect_speed(simulation, 0);
    send(simulation, "grab 0 75");
    send(simulation, "drag 0 1.5 0");
    make_steps(simulation, 400);
    EXPECT_GT(simulation.cloths()[0].state.v.row(40).norm(), 0.05) << "the hand pulls it along";
    EXPECT_EQ(simulation.report().status, Status::Ok);
    EXPECT_EQ(simulation.report().energy_gain_step, 0);
}

}  // namespace
}  // namespace drape
