#include "drape/sim/energy_ledger.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/small_scene.h"

namespace drape {
namespace {

/// `small_simulation` with a ledger.
Simulation kept_simulation(std::vector<std::string> assignments = {}) {
    assignments.emplace_back("ledger=true");
    return small_simulation(assignments);
}

/// The balance after a run without contact, by RK4 with small steps: the method itself then loses next to nothing.
EnergyBalance exact_balance(const std::vector<std::string>& more, const std::vector<Command>& commands = {}) {
    std::vector<std::string> assignments{"integrator=rk4", "dt=2.5e-4", "ball.position=0,-9,0", "sleep_speed=0"};
    assignments.insert(assignments.end(), more.begin(), more.end());
    Simulation simulation = kept_simulation(assignments);
    make_steps(simulation, 400);
    for (const Command& command : commands) simulation.apply(command);
    make_steps(simulation, 800);
    return simulation.view().report->balance;
}

double mechanical_energy(Simulation& simulation) { return simulation.view().report->energy.total(); }

TEST(EnergyLedger, LeavesNothingToAnExactMethod) {
    const EnergyBalance balance = exact_balance({"structural.damping=0.2", "drag=0.001"});
    EXPECT_GT(balance.damping, 1e-4);
    EXPECT_GT(balance.drag, 1e-3);
    EXPECT_LT(std::abs(balance.integrator), 1e-4 * balance.damping);
    EXPECT_EQ(balance.wind, 0);
    EXPECT_EQ(balance.hand, 0);
    EXPECT_EQ(balance.ball, 0);
    EXPECT_EQ(balance.contact, 0);
}

TEST(EnergyLedger, KnowsTheWorkOfWindAndHand) {
    const EnergyBalance windy = exact_balance({"wind.on=true", "wind.velocity=0,0,3"});
    EXPECT_GT(std::abs(windy.wind), 1e-4);
    EXPECT_LT(std::abs(windy.integrator), 1e-3 * std::abs(windy.wind));
    const EnergyBalance pulled = exact_balance({}, {command::Grab{0, 75}, command::Drag{Vec3(0.3, 0.8, 0.6)}});
    EXPECT_GT(pulled.hand, 1e-2);
    EXPECT_LT(std::abs(pulled.integrator), 1e-3 * pulled.hand);
}

/// A ball of speed V takes a particle along: it does the work m V^2, of which the particle has one half and the impact
/// takes the other.
TEST(EnergyLedger, SharesAnInelasticImpactInHalves) {
    Simulation simulation =
        kept_simulation({"pinned=none", "structural.stiffness=0", "shear.stiffness=0", "bend.stiffness=0",
                         "structural.damping=0", "shear.damping=0", "bend.damping=0", "drag=0.5", "friction=0",
                         "ball.radius=0.05", "motion=path", "path=0,0,-1,0.5,1,0,2,0.5", "plane=xz"});
    while (simulation.report().contacts == 0 && simulation.report().step < 1000) simulation.step();
    ASSERT_GT(simulation.report().contacts, 0);
    const EnergyBalance balance = simulation.view().report->balance;
    EXPECT_GT(balance.ball, 1e-4);
    // The cloth falls slowly through thick air
    EXPECT_NEAR(balance.contact / balance.ball, 0.5, 0.05);
}

/// A ball lifts a cloth by pushes of which the warm start gives half: little of their work is booked as the method's.
TEST(EnergyLedger, BooksHardlyAnyOfTheWorkOfContactAsTheMethods) {
    Simulation simulation =
        kept_simulation({"integrator=rk4", "dt=2.5e-4", "pinned=none", "plane=xz", "centre=0,0.26,0",
                         "ball.position=0,0,0", "motion=path", "path=0,0,0,0,1,0,0.3,0"});
    make_steps(simulation, 2000);
    const EnergyBalance balance = simulation.view().report->balance;
    EXPECT_GT(balance.ball, 0.05);
    EXPECT_LT(std::abs(balance.integrator), 0.03 * balance.ball);
    EXPECT_EQ(balance.wind, 0);
}

/// What a free ball loses is its work on the sheet that it comes to lie in, by the warm start and by the response.
TEST(LongEnergyLedger, CountsWhatAFreeBallGives) {
    Settings settings = load_scene("trampoline");
    settings.solver.integrator = IntegratorKind::VelocityVerlet;
    settings.solver.ledger = true;
    const double weight = static_cast<double>(settings.balls[0].mass) * 9.81;
    const auto start = static_cast<double>(settings.balls[0].position.y());
    Simulation simulation("trampoline", std::move(settings));
    for (const double time : {0.5, 3.0}) {
        run_until(simulation, time);
        const Body ball = body_of(simulation.balls()[0], {});
        const double lost = weight * (start - static_cast<double>(ball.centre.y())) - kinetic_energy({&ball, 1});
        EXPECT_NEAR(simulation.view().report->balance.ball / lost, 1, 0.01) << time << " s";
    }
}

/// A ball that bounces beside a cloth that lies on the ground gives that cloth nothing; the cloth that it hits has all.
TEST(EnergyLedger, CountsAFreeBallForTheClothThatItTouches) {
    Settings settings = load_scene("drop");
    settings.cloths[0].particles = {8, 8};
    assign(settings, "cloth.centre=3,0.004,0");
    BallSettings& ball = settings.balls[0];
    ball.motion = BallMotion::Free;
    ball.mass = Real(0.5);
    ball.position = {0, 1, 0};
    settings.solver.ledger = true;
    for (const bool has_second : {false, true}) {
        if (has_second) {
            settings.cloths.push_back(settings.cloths[0]);
            assign(settings, "cloth[1].centre=0,0.5,0");
            assign(settings, "cloth[1].pinned=border");
        }
        Simulation simulation("ball", settings);
        run_until(simulation, 0.6);
        EXPECT_GT(simulation.report().contacts, 20);
        EXPECT_EQ(simulation.report().energy_gain_step, 0);
        const double work = simulation.view().report->balance.ball;
        EXPECT_TRUE(has_second ? work > 0.05 : work == 0) << work;
    }
}

/// A step lets cloth that lies on a ball fall, and the pushes of the substep before lift it again: neither row grows.
TEST(EnergyLedger, BooksNothingWhileNothingMoves) {
    Settings settings = shipped_settings("drop", {"integrator=bdf2", "ledger=true", "sleep_speed=0"});
    settings.cloths[0].drag *= Real(900) / 196;
    settings.cloths[0].particles = {14, 14};
    settings.solver.dt = 1.0 / 60;
    Simulation simulation("drop", std::move(settings));
    run_until(simulation, 6);
    const EnergyBalance before = simulation.view().report->balance;
    run_until(simulation, 8);
    const EnergyBalance after = simulation.view().report->balance;
    EXPECT_NEAR(after.contact, before.contact, 2e-4);
    EXPECT_NEAR(after.integrator, before.integrator, 2e-4);
    EXPECT_NEAR(after.damping, before.damping, 2e-4);
}

/// A cloth so soft that its weight draws it out to its limit, which stops its fall.
TEST(EnergyLedger, CountsWhatTheStretchLimitTakesAsTheMethods) {
    const std::vector<std::string> soft{"structural.stiffness=1", "shear.stiffness=0",       "bend.stiffness=0",
                                        "shear.damping=0",        "structural.damping=0",    "bend.damping=0",
                                        "ball.position=0,-9,0",   "cloth.stretch_limit=0.1", "drag=0"};
    Simulation simulation = kept_simulation(soft);
    const double before = mechanical_energy(simulation);
    make_steps(simulation, 1000);
    const EnergyBalance balance = simulation.view().report->balance;
    EXPECT_GT(balance.integrator, 0.01) << "J";
    EXPECT_NEAR(balance.integrator, before - mechanical_energy(simulation), 1e-10);
}

/// Whatever happens in a run, nothing is forgotten and nothing counted twice.
TEST(EnergyLedger, AddsUpToTheChangeOfTheEnergy) {
    Simulation simulation = kept_simulation({"ball.position=0,0.2,0.2"});
    const double before = mechanical_energy(simulation);
    const auto expect_balanced = [&](const char* what) {
        EXPECT_NEAR(simulation.view().report->balance.change(), mechanical_energy(simulation) - before, 1e-10) << what;
    };
    make_steps(simulation, 300);
    EXPECT_GT(simulation.report().contacts, 0);
    expect_balanced("contact");
    for (const char* text :
         {"set wind.on=true", "set cloth.mass=0.2", "grab 0 75", "drag 0.3 0.8 0.6", "steer 0 0 1"}) {
        simulation.apply(parse_command(text));
        make_steps(simulation, 60);
        expect_balanced(text);
    }
    for (const char* text :
         {"release", "steer 0 0 0", "set wind.on=false", "set drag=0.01", "set structural.damping=1"}) {
        simulation.apply(parse_command(text));
    }
    for (int i = 0; i < 20000 && !simulation.report().asleep; ++i) simulation.step();
    EXPECT_TRUE(simulation.report().asleep);
    expect_balanced("asleep");
}

/// A cloth that swings in the wind against a ball.
Simulation windy_simulation(const std::string& integrator, const std::string& kernels, bool ledger) {
    Simulation simulation = small_simulation({"integrator=" + integrator, "solver.kernels=" + kernels,
                                              ledger ? "ledger=true" : "ledger=false", "ball.position=0,0.2,0.2",
                                              "wind.on=true", "sleep_speed=0"});
    simulation.apply(parse_command("grab 0 75"));
    simulation.apply(parse_command("drag 0.3 0.8 0.6"));
    make_steps(simulation, 200);
    return simulation;
}

TEST(EnergyLedger, ChangesNoBitOfTheMotion) {
    for (const std::string_view integrator : names_of<IntegratorKind>()) {
        for (const char* kernels : {"plain", "vector"}) {
            const std::string name(integrator);
            EXPECT_EQ(windy_simulation(name, kernels, true).hash(), windy_simulation(name, kernels, false).hash())
                << name << " " << kernels;
        }
    }
}

}  // namespace
}  // namespace drape
