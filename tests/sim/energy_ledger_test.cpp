#include "drape/sim/energy_ledger.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drape/contact/response.h"
#include "drape/sim/scene.h"
#include "small_scene.h"

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

TEST(EnergyLedger, KnowsTheWorkOfTheWind) {
    const EnergyBalance balance = exact_balance({"wind.on=true", "wind.velocity=0,0,3"});
    EXPECT_GT(std::abs(balance.wind), 1e-4);
    EXPECT_LT(std::abs(balance.integrator), 1e-3 * std::abs(balance.wind));
}

TEST(EnergyLedger, KnowsTheWorkOfTheHand) {
    const EnergyBalance balance = exact_balance({}, {command::Grab{0, 75}, command::Drag{Vec3(0.3, 0.8, 0.6)}});
    EXPECT_GT(balance.hand, 1e-2);
    EXPECT_LT(std::abs(balance.integrator), 1e-3 * balance.hand);
}

TEST(EnergyLedger, CountsWhatTheHandsOwnSpeedTakes) {
    Simulation simulation =
        kept_simulation({"integrator=rk4", "ball.position=0,-9,0", "structural.stiffness=0", "shear.stiffness=0",
                         "bend.stiffness=0", "structural.damping=0", "shear.damping=0", "bend.damping=0", "drag=0"});
    simulation.apply(parse_command("grab 0 75"));
    simulation.apply(parse_command("drag 0.9 0.9 0.9"));
    make_steps(simulation, 5);
    const double mass = 0.1 / 80, speed = simulation.cloths()[0].state.v.row(75).norm();
    EXPECT_GT(speed, 2);
    EXPECT_GT(simulation.view().report->balance.hand, mass * speed * speed / 2);
    EXPECT_NEAR(simulation.view().report->balance.integrator, 0, 1e-12);
}

TEST(EnergyLedger, CountsAChangeOfTheClothAsTheHands) {
    Simulation simulation = kept_simulation({"ball.position=0,-9,0"});
    make_steps(simulation, 200);
    const StepReport before = *simulation.view().report;
    simulation.apply(parse_command("set structural.stiffness=400"));
    make_steps(simulation, 1);
    EXPECT_GT(before.energy.spring, 0);
    EXPECT_EQ(before.balance.hand, 0);
    EXPECT_GT(simulation.view().report->balance.hand, before.energy.spring / 2);
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
    for (const char* kernels : {"plain", "vector"}) {
        Simulation simulation = kept_simulation(
            {"integrator=rk4", "dt=2.5e-4", "pinned=none", "plane=xz", "centre=0,0.26,0", "ball.position=0,0,0",
             std::string("solver.kernels=") + kernels, "motion=path", "path=0,0,0,0,1,0,0.3,0"});
        make_steps(simulation, 2000);
        const EnergyBalance balance = simulation.view().report->balance;
        EXPECT_GT(balance.ball, 0.05);
        EXPECT_LT(std::abs(balance.integrator), 0.03 * balance.ball) << kernels;
        EXPECT_EQ(balance.wind, 0);
    }
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
        while (simulation.report().time < time) simulation.step();
        const Ball ball = simulation.balls()[0];
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
        while (simulation.report().time < 0.6) simulation.step();
        EXPECT_GT(simulation.report().contacts, 20);
        EXPECT_EQ(simulation.report().heated_step, 0);
        const double work = simulation.view().report->balance.ball;
        if (has_second) {
            EXPECT_GT(work, 0.05);
        } else {
            EXPECT_EQ(work, 0);
        }
    }
}

/// A step lets cloth that lies on a ball fall, and the pushes of the substep before lift it again: neither row grows.
TEST(EnergyLedger, BooksNothingWhileNothingMoves) {
    struct Method {
        IntegratorKind integrator;
        double step;
    };
    for (const Method& method : {Method{IntegratorKind::SymplecticEuler, 3.125e-4}, {IntegratorKind::Bdf2, 1.0 / 60}}) {
        Settings settings = load_scene("drop");
        settings.cloths[0].drag *= Real(900) / 196;
        settings.cloths[0].particles = {14, 14};
        settings.solver.integrator = method.integrator;
        settings.solver.dt = method.step;
        settings.solver.ledger = true;
        settings.solver.sleep_speed = 0;
        Simulation simulation("drop", std::move(settings));
        const auto balance_at = [&](double time) {
            while (simulation.report().time < time) simulation.step();
            return simulation.view().report->balance;
        };
        const EnergyBalance before = balance_at(6), after = balance_at(8);
        EXPECT_NEAR(after.contact, before.contact, 2e-4) << name_of(method.integrator);
        EXPECT_NEAR(after.integrator, before.integrator, 2e-4) << name_of(method.integrator);
        EXPECT_NEAR(after.damping, before.damping, 2e-4) << name_of(method.integrator);
    }
}

/// A ball that lifts cloth gives what that gains in height, and the contacts that hand it on keep little of it.
TEST(EnergyLedger, HandsOnTheWorkOfABallThatLifts) {
    for (const auto integrator : {IntegratorKind::SymplecticEuler, IntegratorKind::VelocityVerlet}) {
        Settings settings = load_scene("drop");
        settings.cloths[0].drag *= Real(900) / 196;
        settings.cloths[0].particles = {14, 14};
        settings.solver.integrator = integrator;
        settings.solver.ledger = true;
        const Vec3 low = settings.balls[0].position, high = low + Vec3(0, Real(0.2), 0);
        settings.balls[0].motion = BallMotion::Path;
        settings.balls[0].path = {{0, low}, {4, low}, {5, low}, {7, high}, {8, high}};
        Simulation simulation("drop", std::move(settings));
        while (simulation.report().time < 4) simulation.step();
        const EnergyBalance before = simulation.view().report->balance;
        while (simulation.report().time < 8) simulation.step();
        const EnergyBalance after = simulation.view().report->balance;
        const double given = after.ball - before.ball;
        EXPECT_GT(given, 0.1) << name_of(integrator);
        EXPECT_NEAR(after.contact, before.contact, 0.25 * given) << name_of(integrator);
        EXPECT_NEAR(after.integrator, before.integrator, 0.25 * given) << name_of(integrator);
    }
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

TEST(EnergyLedger, ShowsWhatAMethodInvents) {
    Simulation simulation = kept_simulation({"integrator=explicit_euler", "dt=5e-4", "ball.position=0,-9,0",
                                             "structural.damping=0", "shear.damping=0", "bend.damping=0", "drag=0"});
    const double before = mechanical_energy(simulation);
    make_steps(simulation, 100);
    const double gained = mechanical_energy(simulation) - before;
    EXPECT_GT(gained, 1e-6);
    EXPECT_NEAR(simulation.view().report->balance.integrator, -gained, 1e-12);
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

TEST(EnergyLedger, ForgetsWhatIsTakenBack) {
    Simulation simulation = kept_simulation();
    make_steps(simulation, 100);
    const Cloth& cloth = simulation.cloths()[0];
    Points scratch(cloth.state.x.rows(), 3);
    const auto flow = [&](const ClothState& state) {
        return compute_energy_flow(cloth.model, state.x, state.v, scratch, Kernels::Vector);
    };
    EnergyLedger ledger(flow(cloth.state));
    ledger.mark();
    ClothState faster = cloth.state;
    faster.v *= 2;
    ledger.integrated(1e-3F);
    EXPECT_GT(ledger.balance(flow(faster)).change(), 0);
    ledger.see(flow(faster));
    ledger.return_to_mark();
    EXPECT_EQ(ledger.balance(flow(cloth.state)).change(), 0) << "it knows the state that has come back";
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

TEST(EnergyLedger, IsTheSameToRoundingWithPlainCodeAndWithKernels) {
    Simulation plain = windy_simulation("symplectic_euler", "plain", true);
    Simulation vector = windy_simulation("symplectic_euler", "vector", true);
    const StepReport one = *plain.view().report, other = *vector.view().report;
    EXPECT_NE(one.balance.contact, 0);
    EXPECT_NE(one.balance.wind, 0);
    EXPECT_NE(one.balance.hand, 0);
    constexpr double part = 1e-7;  // of differences that have grown for 200 steps
    for (const char* name : {"energy", "damping_loss", "drag_loss", "contact_loss", "integrator_loss", "wind_work",
                             "hand_work", "ball_work", "step_limit_ratio", "energy_excess"}) {
        EXPECT_NEAR(figure(one, name), figure(other, name), part * std::max(std::abs(figure(one, name)), 1e-3)) << name;
    }
}

TEST(EnergyLedger, IsKeptOnlyIfItIsWanted) {
    Simulation simulation = small_simulation();
    make_steps(simulation, 50);
    EXPECT_TRUE(std::isnan(simulation.view().report->balance.damping)) << "it is not kept, rather than nothing";
    simulation.apply(parse_command("set solver.ledger=true"));
    make_steps(simulation, 50);
    EXPECT_GT(simulation.view().report->balance.damping, 0);
    simulation.apply(parse_command("set solver.ledger=false"));
    EXPECT_TRUE(std::isnan(simulation.view().report->balance.change()));
}

/// Two small cloths far apart, each lifted by a ball of its own.
Settings two_lifts() {
    Settings settings;
    settings.cloths.clear();
    for (const Real x : {Real(0), Real(2)}) {
        ClothParameters cloth;
        cloth.particles = {7, 7};
        cloth.width = cloth.height = Real(0.4);
        cloth.centred = true;
        cloth.place = {x, Real(0.002), 0};
        settings.cloths.push_back(cloth);
        BallSettings ball;
        ball.motion = BallMotion::Path;
        ball.path = {{0, {x, Real(-0.3), 0}}, {Real(0.2), {x, Real(-0.3), 0}}, {Real(1.2), {x, Real(0.7), 0}}};
        settings.balls.push_back(ball);
    }
    settings.contact.friction = 1;
    settings.ground.height = -1;
    settings.solver.integrator = IntegratorKind::BackwardEuler;
    settings.solver.dt = 2e-3;
    return settings;
}

TEST(EnergyWatch, GivesEachClothTheWorkOfTheBallsThatPushIt) {
    Simulation simulation("two lifts", two_lifts());
    make_steps(simulation, 600);
    EXPECT_GT(simulation.cloths()[1].state.x.col(1).maxCoeff(), 0.8) << "it has been lifted";
    EXPECT_EQ(simulation.run_warning(), "");
}

}  // namespace
}  // namespace drape
