#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "sim/small_scene.h"
#include "support/sanitized.h"

namespace drape {
namespace {

TEST(Ground, HoldsNothingOnceItIsAwayOrLower) {
    for (const std::string integrator : {"velocity_verlet", "symplectic_euler", "backward_euler"}) {
        for (const std::string change : {"ground.solid=false", "ground.height=-0.5"}) {
            Simulation simulation = shipped_simulation("drop", {"cloth.particles=10,10", "cloth.centre=0,0.01,0",
                                                                "ball.position=5,0.3,0", "integrator=" + integrator});
            run_until(simulation, 0.3);
            EXPECT_GT(simulation.report().contacts, 50);
            send(simulation, "set " + change);
            run_until(simulation, 1.5);
            const Real lowest = simulation.cloths()[0].state.x.col(1).minCoeff();
            EXPECT_LT(lowest, Real(-0.49)) << integrator << ", " << change;
        }
    }
}

TEST(Ground, IsWhereTheKeysCanLeadABallAndNoFartherThanClothUnderItLetsThem) {
    Simulation simulation = shipped_simulation(
        "drop", {"cloth.particles=12,12", "cloth.centre=0,0.01,0", "ball.position=0,0.4,0", "ball.motion=keys"});
    run_until(simulation, 0.2);
    send(simulation, "steer 0 -1 0");
    run_until(simulation, 1);
    const Ball& ball = simulation.balls()[0];
    const Real ground = simulation.settings().ground.height, thickness = simulation.settings().contact.thickness;
    EXPECT_NEAR(ball.centre.y(), ground + ball.radius + 2 * thickness, thickness / 10);
    EXPECT_GE(simulation.cloths()[0].state.x.col(1).minCoeff(), ground + thickness / 2);
}

/// How high the hand is, lowest, on its way to a target far below the ground, past a ball that lies on it.
Real lowest_of_hand(bool solid) {
    Simulation simulation = shipped_simulation(
        "drop", {"cloth.particles=12,12", std::string("ground.solid=") + (solid ? "true" : "false")});
    send(simulation, "grab 0 0");
    send(simulation, "drag 0.02 -1 0.01");
    const Ball ball = simulation.balls()[0];
    Real lowest = 1;
    run_until(simulation, 1.2, [&] {
        const Vec3 hand = position_of(simulation, 0);
        EXPECT_GE((hand - ball.centre).norm(), ball.radius);
        lowest = std::min(lowest, hand.y());
    });
    return lowest;
}

/// Between ball and ground the hand has but one way out.
TEST(Ground, StopsTheHandWhereItIsSolidAndABallLeavesTheHandOutside) {
    const Real thickness = load_scene("drop").contact.thickness;
    EXPECT_GE(lowest_of_hand(true), thickness * Real(0.9));
    EXPECT_LT(lowest_of_hand(false), -0.3);
}

TEST(SteeredBall, ThatACommandTakesAwayLeavesTheClothWhereItIs) {
    Simulation simulation = shipped_simulation("original", {"cloth.particles=15,15", "ball.position=0,-0.2,0"});
    run_until(simulation, 0.3);
    ASSERT_GT(simulation.report().contacts, 0);
    send(simulation, "set ball.position=9,1,0");
    const Points before = simulation.cloths()[0].state.x;
    simulation.step();
    EXPECT_LT((simulation.cloths()[0].state.x - before).cwiseAbs().maxCoeff(), 0.01);
}

/// A heavy ball that is before a hung curtain at the end of one step, and behind it at the end of the next.
Simulation bullet(const std::string& integrator, Real speed, const std::string& continuous) {
    const Real way = speed / 60;
    return shipped_simulation("curtain", {"integrator=" + integrator, "dt=0.016666666666666666", "contact.self=false",
                                          "contact.continuous=" + continuous, "ball.motion=free", "ball.mass=1000",
                                          "ball.position=0,0.75," + std::to_string(-Real(3.5) * way),
                                          "ball.velocity=0,0," + std::to_string(speed)});
}

/// Whether a ball has cloth behind it where it is, and none before it, along z.
bool is_through(const Cloth& cloth, const Ball& ball) {
    bool behind = false;
    for (int t = 0; t < cloth.model.grid.triangles(); ++t) {
        const auto corners = cloth.model.grid.triangle_corners(t);
        const auto at = [&](std::size_t k) { return Vec3(cloth.state.x.row(corners[k]).transpose() - ball.centre); };
        // The signed areas that the ball's way makes with two corners each
        const auto area = [&](std::size_t k, std::size_t m) { return at(k).x() * at(m).y() - at(k).y() * at(m).x(); };
        const Vec3 areas(area(1, 2), area(2, 0), area(0, 1));
        if (areas.minCoeff() * areas.maxCoeff() < 0 || areas.sum() == 0) continue;
        const Real z = (areas[0] * at(0).z() + areas[1] * at(1).z() + areas[2] * at(2).z()) / areas.sum();
        if (z > -ball.radius) return false;
        behind = true;
    }
    return behind;
}

/// Whether the ball has not gone through the curtain.
bool holds(Simulation simulation) {
    make_steps(simulation, 4);
    EXPECT_EQ(simulation.report().status, Status::Ok) << simulation.report().error;
    const Ball& ball = simulation.balls()[0];
    EXPECT_GT(ball.centre.z(), 0.2);
    return !is_through(simulation.cloths()[0], ball);
}

TEST(ContinuousDetection, StopsABallThatCrossesTheClothWithinAStep) {
    for (const std::string integrator : {"backward_euler", "projective_dynamics", "xpbd"}) {
        for (const Real speed : {30, 60, 100}) {
            EXPECT_TRUE(holds(bullet(integrator, speed, "auto"))) << integrator << " " << speed;
            if (integrator == "xpbd") continue;  // whose steps are divided where a ball is free
            EXPECT_FALSE(holds(bullet(integrator, speed, "false"))) << integrator << " " << speed;
        }
    }
}

/// Shots with each response.
class LightBall : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Few, LightBall, testing::Values(test::sanitized ? 4 : 8));
INSTANTIATE_TEST_SUITE_P(Nightly, LightBall, testing::Values(20));

/// A long step that stopped a light ball on its own would draw springs out so far that they throw it back faster than
/// it came, or let it through.
TEST_P(LightBall, IsNeitherLetThroughNorThrownBack) {
    std::mt19937 random(5);
    const auto between = [&](Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(random); };
    for (const std::string response : {"projection", "impulse", "hybrid"}) {
        for (int shot = 0; shot < GetParam(); ++shot) {
            const std::string integrator = shot % 2 == 0 ? "backward_euler" : "xpbd";
            const bool heavier = shot % 4 >= 2;  // and draws the triangles that it hits out to three times their length
            const std::string mass = heavier ? "0.03" : "0.004";
            const Real speed = between(20, 100), from = between(Real(0.05), 2);
            const std::string place = std::to_string(between(Real(-0.3), Real(0.3))) + "," +
                                      std::to_string(between(Real(0.4), 1)) + "," + std::to_string(-from);
            Simulation simulation = shipped_simulation(
                "bullet", {"integrator=" + integrator, "response=" + response, "dt=0.016666666666666666",
                           "ball.radius=0.01", "ball.mass=" + mass, "contact.thickness=0.002", "ball.position=" + place,
                           "ball.velocity=0,0," + std::to_string(speed)});
            run_until(simulation, from / speed + Real(0.05));
            const Ball& ball = simulation.balls()[0];
            SCOPED_TRACE(integrator + ", " + response + ", " + mass + " kg, " + std::to_string(speed) + " m/s from " +
                         place);
            EXPECT_FALSE(is_through(simulation.cloths()[0], ball));
            EXPECT_LT(ball.velocity.norm(), speed + 1);
            EXPECT_LT(ball.velocity.z(), speed * (heavier ? Real(0.9) : Real(0.5))) << "it has hit the sheet";
        }
    }
}

/// By either name.
TEST(ContinuousDetection, ChangesNoBitWhereNothingCrosses) {
    const std::string few = "cloth.particles=16,16";
    Simulation never = shipped_simulation("drop", {few, "contact.continuous=false"});
    run_until(never, 0.7);
    ASSERT_GT(never.report().contacts, 0);
    for (const std::string looks : {"auto", "true"}) {
        Simulation looking = shipped_simulation("drop", {few, "contact.continuous=" + looks});
        run_until(looking, 0.7);
        EXPECT_EQ(looking.hash(), never.hash()) << looks;
    }
}

TEST(Ground, ThrowsNothingBackWithoutRestitutionWhileTheWayIsTested) {
    Simulation simulation =
        shipped_simulation("drop", {"ball.position=5,0.3,0", "contact.continuous=true", "cloth.centre=0,0.012,0"});
    Real highest = 0;
    run_until(simulation, 0.1);
    run_until(simulation, 0.2, [&] { highest = std::max(highest, simulation.cloths()[0].state.v.col(1).maxCoeff()); });
    EXPECT_LT(highest, 0.05);
}

TEST(StepsInContact, AreDividedUnderAnImplicitMethodAlone) {
    for (const std::string integrator : {"backward_euler", "symplectic_euler"}) {
        Simulation simulation = shipped_simulation(
            "drop", {"integrator=" + integrator, "dt=3e-4", "longest_step=1e-4", "ball.position=0,0.345,0"});
        EXPECT_EQ(simulation.report().substeps, 1);
        run_until(simulation, 0.3);
        ASSERT_GT(simulation.report().contacts, 0);
        EXPECT_EQ(simulation.report().substeps, integrator == "backward_euler" ? 3 : 1);
    }
}

}  // namespace
}  // namespace drape
