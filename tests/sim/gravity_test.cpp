#include <gtest/gtest.h>

#include <cmath>

#include "small_scene.h"

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

TEST(Gravity, IsThatOfTheEarthAtFirst) {
    Simulation simulation = falling({});
    make_steps(simulation, 400);
    expect_speed(simulation, 9.81 * 0.1);
}

TEST(Gravity, OfTheSceneMovesClothAndFreeBalls) {
    Simulation simulation = falling({"world.gravity=3.7"});
    make_steps(simulation, 400);
    expect_speed(simulation, 3.7 * 0.1);
    simulation.apply(parse_command("set world.gravity=1.6"));
    make_steps(simulation, 400);
    expect_speed(simulation, 3.7 * 0.1 + 1.6 * 0.1);
    simulation.apply(command::Reset{});
    make_steps(simulation, 400);
    expect_speed(simulation, 1.6 * 0.1);
    EXPECT_EQ(simulation.report().heated_step, 0);
}

TEST(Gravity, OfNoneLeavesAllWhereItIs) {
    Simulation simulation = falling({"world.gravity=0", "wind.velocity=0,0,0"});
    make_steps(simulation, 400);
    expect_speed(simulation, 0);

    simulation.apply(parse_command("grab 0 75"));
    simulation.apply(parse_command("drag 0 1.5 0"));
    make_steps(simulation, 400);
    EXPECT_GT(simulation.cloths()[0].state.v.row(40).norm(), 0.05) << "the hand pulls it along";
    EXPECT_EQ(simulation.report().status, Status::Ok);
    EXPECT_EQ(simulation.report().heated_step, 0);
}

TEST(Gravity, ThatChangesWakesAClothThatSleeps) {
    Simulation simulation = falling({"world.gravity=0", "sleep_speed=1e-4"});
    while (!simulation.report().asleep && simulation.report().time < 10) simulation.step();
    ASSERT_TRUE(simulation.report().asleep);
    simulation.apply(parse_command("set world.gravity=1.6"));
    make_steps(simulation, 400);
    expect_speed(simulation, 1.6 * 0.1);
}

/// As of a cloth that is made heavier, what the change gives is the hand's.
TEST(Gravity, ThatChangesKeepsTheEnergyBalance) {
    Simulation simulation = falling({"integrator=rk4"});
    make_steps(simulation, 400);
    simulation.apply(parse_command("set world.gravity=3"));
    make_steps(simulation, 400);
    const EnergyBalance balance = simulation.view().report->balance;
    EXPECT_GT(std::abs(balance.hand), 1e-3);
    EXPECT_LT(std::abs(balance.integrator), 1e-6);
}

}  // namespace
}  // namespace drape
