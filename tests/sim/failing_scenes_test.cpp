#include <gmock/gmock.h>

#include <map>

#include "drape/contact/response.h"
#include "drape/integrate/stability.h"
#include "sim/scene_lists.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

constexpr double run_time = 1;  // s

Real predicted(const Settings& settings) {
    const ClothParameters& cloth = settings.cloths[0];
    return predicted_limit(make_cloth_model(cloth), make_rest_state(cloth), settings.solver.integrator, Kernels::Vector)
        .step;
}

Status after_a_while(const std::string& scene, const Settings& settings) {
    Simulation simulation(scene, settings);
    make_steps(simulation, static_cast<int>(run_time / settings.solver.dt));
    return simulation.report().status;
}

class FailingScene : public testing::TestWithParam<std::string> {};

TEST_P(FailingScene, SaysSoAndWarnsWhereItsMethodHasALimit) {
    const Settings settings = load_scene(GetParam());
    EXPECT_THAT(settings.title, testing::StartsWith("Fails: "));
    EXPECT_EQ(Simulation(GetParam(), settings).step_warning() != "", has_step_limit(settings.solver.integrator));
}

TEST_P(FailingScene, FailsAsItsTitleSays) {
    if (GetParam() == "fails_xpbd") GTEST_SKIP() << "it does not diverge";
    EXPECT_EQ(after_a_while(GetParam(), load_scene(GetParam())), Status::Diverged);
}

TEST(FailingScenes, SayWhichParticleAndSpringWereFirst) {
    for (const std::string name : {"fails_rk4", "fails_symplectic_euler"}) {
        Simulation simulation(name, load_scene(name));
        EXPECT_EQ(simulation.report().failure.particle, -1);
        while (simulation.report().status == Status::Ok && simulation.report().time < run_time) simulation.step();
        const StepReport& report = simulation.report();
        EXPECT_EQ(report.failure.cloth, 0);
        EXPECT_THAT(report.trouble, testing::HasSubstr("particle " + std::to_string(report.failure.particle) + " ("));
        EXPECT_THAT(report.trouble, testing::HasSubstr("spring to " + std::to_string(report.failure.other)));
        simulation.apply(command::Reset{});
        EXPECT_EQ(simulation.report().failure.particle, -1) << "after a reset";
    }
}

double stretch_of_xpbd(int iterations) {
    Settings settings = load_scene("fails_xpbd");
    settings.solver.iterations = iterations;
    Simulation simulation("fails_xpbd", settings);
    make_steps(simulation, 59);
    EXPECT_EQ(simulation.report().status, Status::Ok);
    return simulation.view().report->stretch;
}

TEST(FailingScenes, OfXpbdWithOneIterationIsFarTooSoft) {
    EXPECT_GT(stretch_of_xpbd(1), 1);
    EXPECT_LT(stretch_of_xpbd(500), 0.1);
}

TEST(FailingScenes, OfImplicitMethodsRunWithTheClampedHessian) {
    for (const std::string name : {"fails_backward_euler", "fails_implicit_midpoint"}) {
        Settings settings = load_scene(name);
        EXPECT_EQ(settings.solver.hessian, Hessian::Exact);
        settings.solver.hessian = Hessian::Clamped;
        EXPECT_EQ(after_a_while(name, settings), Status::Ok) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(All, FailingScene, testing::ValuesIn(scenes_that_fail(true)),
                         [](const auto& scene) { return scene.param; });

TEST(FailingScenes, AboveALimitAreTwoPercentAboveItAndRunWithThreePercentLess) {
    for (const std::string name : {"fails_symplectic_euler", "fails_rk4"}) {
        Settings settings = load_scene(name);
        EXPECT_NEAR(settings.solver.dt / predicted(settings), 1.02, 0.002) << name;
        settings.solver.dt *= 0.97;
        EXPECT_EQ(after_a_while(name, settings), Status::Ok) << name;
    }
}

TEST(FailingScenes, OfThePenaltyIsFarAboveItsLimitAndRunsBelow) {
    Settings settings = load_scene("fails_penalty");
    const ClothModel model = make_cloth_model(settings.cloths[0]);
    const Real ratio = static_cast<Real>(settings.solver.dt) /
                       penalty_step_limit(settings.contact.stiffness, 0, 1 / model.particle_mass);
    EXPECT_NEAR(ratio, 25, 0.5);
    settings.contact.stiffness *= Real(0.9) / (ratio * ratio);
    EXPECT_EQ(after_a_while("fails_penalty", settings), Status::Ok);
}

std::string trouble_of(const std::string& scene) {
    Simulation simulation(scene, load_scene(scene));
    while (simulation.report().status == Status::Ok && simulation.report().time < run_time) simulation.step();
    return simulation.report().trouble;
}

TEST(FailingScenes, SayHowFarAboveWhichLimitTheyAre) {
    EXPECT_THAT(trouble_of("fails_rk4"),
                testing::MatchesRegex("Diverged at step [0-9]+ \\(rk4\\)\\. Time step is 1\\.02 x the limit; use at "
                                      "most [0-9.]+ ms\\. First: particle [0-9]+ .* at [0-9.]+ m/s.*"));
    EXPECT_THAT(trouble_of("fails_penalty"),
                testing::HasSubstr(". Time step is 25.3 x the limit; use at most 0.0123 ms. First: particle "));
    EXPECT_THAT(trouble_of("fails_explicit_euler"),
                testing::HasSubstr(". No time step of explicit_euler that may be set is stable here: "));
}

TEST(LongFailingScenes, RunAtNineTenthsOfTheLongestStep) {
    for (const std::string name : {"fails_symplectic_euler", "fails_rk4", "fails_penalty"}) {
        Settings settings = load_scene(name);
        const double longest = Simulation(name, settings).longest_step();
        EXPECT_LT(longest, settings.solver.dt) << name;
        settings.solver.dt = 0.9 * longest;
        Simulation simulation(name, settings);
        while (simulation.report().time < 0.4 * run_time && simulation.report().status == Status::Ok) simulation.step();
        EXPECT_EQ(simulation.report().status, Status::Ok) << name;
    }
}

TEST(FailingScenes, OfExplicitEulerRunWithAnotherMethodAtThatStep) {
    Settings settings = load_scene("fails_explicit_euler");
    EXPECT_EQ(predicted(settings), 0);
    settings.solver.integrator = IntegratorKind::SymplecticEuler;
    EXPECT_LT(settings.solver.dt, Real(0.5) * predicted(settings));
    EXPECT_EQ(after_a_while("fails_explicit_euler", settings), Status::Ok);
}

}  // namespace
}  // namespace drape
