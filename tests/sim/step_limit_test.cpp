// Steps beyond the limit of a method: said, divided into substeps, or diverged and kept for study.

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "drape/integrate/stability.h"
#include "drape/session/failure.h"
#include "sim/small_scene.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using testing::AllOf;
using testing::HasSubstr;

double limit_of(const Simulation& simulation) {
    const Cloth& cloth = simulation.cloths()[0];
    return predicted_limit(cloth.model, cloth.state, simulation.settings().solver.integrator, Kernels::Vector).step;
}

TEST(StepWarning, IsNotNeededForTheShippedScenes) {
    for (const std::string& name : scenes_that_fail(false)) {
        EXPECT_EQ(Simulation(name, load_scene(name)).step_warning(), "") << name;
    }
}

TEST(StepWarning, NamesStepMethodAndHowFarItIsBeyondTheLimit) {
    Simulation simulation = small_simulation({"dt=0.0625"});
    EXPECT_THAT(simulation.step_warning(),
                AllOf(HasSubstr("solver.dt = 0.0625 s is "), HasSubstr("times the stability limit"),
                      HasSubstr("symplectic_euler")));
    EXPECT_NEAR(simulation.report().step_limit_ratio, 0.0625 / limit_of(simulation), 1e-9);
    send(simulation, "set dt=1e-4");
    EXPECT_EQ(simulation.step_warning(), "");
    send(simulation, "set integrator=backward_euler");
    send(simulation, "set dt=0.0625");
    EXPECT_EQ(simulation.step_warning(), "") << "it has no limit";
    EXPECT_EQ(simulation.report().step_limit_ratio, 0);
    send(simulation, "set cloth.drag=0");
    for (const char* damping : {"structural.damping=0", "shear.damping=0", "bend.damping=0"}) {
        send(simulation, std::string("set ") + damping);
    }
    send(simulation, "set integrator=explicit_euler");
    EXPECT_THAT(simulation.step_warning(), HasSubstr("no stable step"));
}

/// The limit is the method's, into however many substeps cloth that meets itself divides a step as it moves.
TEST(StepWarning, IsTheSameWhileAStepIsDividedForMotion) {
    Simulation simulation = shipped_simulation("fold", {"cloth.particles=14,14", "dt=2e-3"});
    const std::string before = simulation.step_warning();
    EXPECT_THAT(before, HasSubstr("times the stability limit"));
    for (int step = 0; step < 400 && simulation.report().substeps == 1; ++step) simulation.step();
    EXPECT_GT(simulation.report().substeps, 1);
    EXPECT_EQ(simulation.step_warning(), before);
}

TEST(StepWarning, SaysAtLeastWhereTheLimitIsOnlyABound) {
    Simulation simulation = small_simulation({"integrator=explicit_euler", "structural.damping=0", "bend.damping=0",
                                              "shear.damping=1", "cloth.drag=0.01", "dt=0.01"});
    EXPECT_THAT(simulation.step_warning(), AllOf(HasSubstr(" is up to "), HasSubstr(", which is at least ")));
    EXPECT_TRUE(simulation.report().limit_is_lower_bound);
    send(simulation, "set integrator=symplectic_euler");
    EXPECT_THAT(simulation.step_warning(), testing::Not(HasSubstr("at least")));
    EXPECT_FALSE(simulation.report().limit_is_lower_bound);
}

TEST(StepWarning, IsOfTheWindUnderImplicitMidpointAndItsSubstepsAreShortEnough) {
    const std::vector<std::string> windy{"integrator=implicit_midpoint", "dt=0.03125", "cloth.mass=0.02",
                                         "wind.on=true", "wind.velocity=0,0,20"};
    Simulation simulation = small_simulation(windy);
    EXPECT_THAT(simulation.step_warning(), HasSubstr("times the stability limit of implicit_midpoint"));
    send(simulation, "set on_unstable=substep");
    EXPECT_EQ(simulation.step_warning(), "");
    EXPECT_GT(simulation.report().substeps, 1);
    send(simulation, "set wind.on=false");
    EXPECT_EQ(simulation.report().substeps, 1);
}

TEST(StepWarning, AsksForNoStepThatMayNotBeSet) {
    Simulation simulation = small_simulation({"structural.stiffness=1e9", "cloth.mass=1e-9"});
    EXPECT_EQ(simulation.longest_step(), 0);
    EXPECT_THAT(simulation.step_warning(), HasSubstr("no step that may be set is short enough"));
    make_steps(simulation, 20);
    EXPECT_THAT(simulation.report().error, AllOf(HasSubstr("No time step of symplectic_euler that may be set"),
                                                 testing::Not(HasSubstr("limit of"))));
}

TEST(StepWarning, LooksAtEveryCloth) {
    Settings settings = load_scene("drop");
    settings.cloths.push_back(settings.cloths.front());
    settings.cloths.back().mass /= 100;
    EXPECT_NE(Simulation("drop", settings).step_warning(), "");
}

TEST(Substeps, AreTheFewestThatStayUnderNineTenthsOfTheLimit) {
    for (const char* dt : {"dt=0.001", "dt=0.004", "dt=0.0078125", "dt=0.03"}) {
        Simulation simulation = small_simulation({dt, "on_unstable=substep"});
        const double step = simulation.settings().solver.dt, limit = limit_of(simulation);
        const int parts = simulation.report().substeps;
        EXPECT_LE(step / parts, 0.9 * limit * (1 + 1e-9)) << dt;
        if (parts > 1) {
            EXPECT_GT(step / (parts - 1), 0.9 * limit) << dt;
        }
        EXPECT_LE(simulation.report().step_limit_ratio, 0.9 * (1 + 1e-9));
    }
    EXPECT_EQ(small_simulation({"dt=0.03"}).report().substeps, 1) << "only where they are asked for";
}

// Its springs are drawn out to several times their length, and vibrate faster than those of the flat sheet
TEST(Substeps, BecomeMoreWhereTheClothIsDrawnOut) {
    Settings settings;
    settings.cloths[0].particles = {16, 16};
    settings.cloths[0].mass = 2;
    settings.cloths[0].pinned.kind = Pins::Kind::Two;
    settings.cloths[0].structural = settings.cloths[0].shear = settings.cloths[0].bend = {100, 0};
    settings.ground.solid = false;
    settings.cloths[0].drag = 0;
    settings.solver.integrator = IntegratorKind::SymplecticEuler;
    settings.solver.dt = Real(0.03);
    settings.solver.on_unstable = OnUnstable::Substep;
    Simulation simulation("soft", settings);
    const int at_first = simulation.report().substeps;
    make_steps(simulation, 1000);
    EXPECT_EQ(simulation.report().status, Status::Ok) << simulation.report().error;
    EXPECT_GT(simulation.report().substeps, at_first);
    // Without them it is lost
    settings.solver.dt /= static_cast<Real>(at_first);
    settings.solver.on_unstable = OnUnstable::Warn;
    Simulation as_at_first("soft", settings);
    make_steps(as_at_first, 1000 * at_first);
    EXPECT_EQ(as_at_first.report().status, Status::Diverged);
}

TEST(Substeps, AreStepsOfTheirLength) {
    Simulation whole = small_simulation({"dt=0.03125", "on_unstable=substep"});
    const int parts = whole.report().substeps;
    ASSERT_GT(parts, 1);
    Simulation fine = small_simulation();
    Settings settings = fine.settings();
    settings.solver.dt = whole.settings().solver.dt / static_cast<Real>(parts);
    settings.solver.sleep_speed = 0;
    fine = Simulation("drop", settings);
    make_steps(whole, 40), make_steps(fine, 40 * parts);
    EXPECT_EQ(whole.hash(), fine.hash());
    EXPECT_EQ(whole.report().solve.force_evaluations, parts) << "of all parts";
}

TEST(Substeps, AreNotTriedWhereAThousandAreTooFew) {
    const Simulation simulation = small_simulation({"integrator=explicit_euler", "dt=0.03125", "on_unstable=substep",
                                                    "structural.damping=0", "shear.damping=0", "bend.damping=0"});
    EXPECT_EQ(simulation.report().substeps, 1);
    EXPECT_THAT(simulation.step_warning(), HasSubstr("too long to be divided into substeps"));
}

Simulation lost_simulation() {
    Simulation simulation = small_simulation({"dt=0.03125", "title=The \"lost\" one"});
    send(simulation, "steer 0 1 0");
    while (simulation.report().status == Status::Ok) simulation.step();
    return simulation;
}

TEST(Failure, IsWrittenAsASceneWhoseFirstStepFailsAlike) {
    const test::ScratchFolder scratch;
    const auto& folder = scratch.path();
    const Simulation lost = lost_simulation();
    const auto scene = write_failure(lost, folder);
    EXPECT_EQ(scene.filename(), "unstable.toml");
    Simulation again(scene.string(), load_scene(scene.string()));
    EXPECT_EQ(again.cloths()[0].state.x, lost.cloths()[0].state.x);
    EXPECT_EQ(again.cloths()[0].state.v, lost.cloths()[0].state.v);
    EXPECT_EQ(again.report().time, lost.report().time);
    EXPECT_EQ(again.hash(), lost.hash()) << "balls included";
    EXPECT_EQ(again.settings().title, "Fails at once: The \"lost\" one");
    again.step();
    ASSERT_EQ(again.report().status, Status::Diverged);
    const std::string what = lost.report().error;
    // The limit is that of a cloth as it was found last, and of this one as it starts
    EXPECT_THAT(again.report().error,
                AllOf(HasSubstr("(symplectic_euler)"), HasSubstr(what.substr(what.find("First:")))));

    EXPECT_EQ(write_failure(lost, folder), scene) << "the same failure again";
    EXPECT_EQ(write_failure(again, folder).filename(), "unstable-2.toml") << "nothing is replaced";
    EXPECT_THAT(tell_failure(lost, folder / "none"), HasSubstr("cannot be written"));
    EXPECT_THAT(what, HasSubstr("x the limit of "));
    EXPECT_THAT(tell_failure(lost, folder), testing::Not(HasSubstr("limit"))) << "which is said already";
}

TEST(Failure, KeepsWhatTheHandHoldsAndWaitsForNoPipeThatHasItsName) {
    const test::ScratchFolder scratch;
    const auto& folder = scratch.path();
    ASSERT_EQ(mkfifo((folder / "unstable.toml").c_str(), 0600), 0);
    Simulation simulation = small_simulation({"dt=0.03125"});
    send(simulation, "grab 0 75");
    while (simulation.report().status == Status::Ok) simulation.step();
    const auto scene = write_failure(simulation, folder);
    EXPECT_EQ(scene.filename(), "unstable-2.toml");
    EXPECT_EQ(load_scene(scene.string()).cloths[0].pinned.list, (std::vector{0, 9, 75}));
}

}  // namespace
}  // namespace drape
