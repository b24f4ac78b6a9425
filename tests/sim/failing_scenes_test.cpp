#include <gmock/gmock.h>

#include "drape/integrate/stability.h"
#include "sim/small_scene.h"

namespace drape {
namespace {

using testing::HasSubstr;

/// A scene after a second, or where it diverged.
Simulation after_a_while(const std::string& scene, const Settings& settings) {
    Simulation simulation(scene, settings);
    while (simulation.report().status == Status::Ok && simulation.report().time < 1) simulation.step();
    return simulation;
}

class FailingScene : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, FailingScene, testing::ValuesIn(scenes_that_fail(true)), name_of_param);

TEST_P(FailingScene, FailsAsItsTitleSaysAndWarnsWhereItsMethodHasALimit) {
    const Settings settings = load_scene(GetParam());
    EXPECT_THAT(settings.title, testing::StartsWith("Fails: "));
    EXPECT_EQ(Simulation(GetParam(), settings).step_warning() != "", has_step_limit(settings.solver.integrator));
    const Status expected = GetParam() == "fails_xpbd" ? Status::Ok : Status::Diverged;  // far too soft, see below
    const Simulation simulation = after_a_while(GetParam(), settings);
    const StepReport& report = simulation.report();
    EXPECT_EQ(report.status, expected);
    EXPECT_GT(report.energy_gain_step, 0) << "its energy is seen too";
    EXPECT_LE(report.energy_gain_step, report.step) << "before it diverges";
}

TEST(FailingScenes, SayWhichParticleAndSpringWereFirstAndHowFarAboveWhichLimitTheyAre) {
    Simulation rk4 = after_a_while("fails_rk4", load_scene("fails_rk4"));
    const StepReport& report = rk4.report();
    EXPECT_THAT(report.error,
                testing::MatchesRegex("Diverged after step [0-9]+ \\(rk4\\)\\. Time step is 1\\.02 x the limit of "
                                      "[0-9.]+ ms\\. First: particle [0-9]+ .* at [0-9.]+ m/s.*"));
    EXPECT_EQ(rk4.step_warning(), "") << "the limit is said once";
    EXPECT_EQ(report.failure.cloth, 0);
    EXPECT_THAT(report.error, HasSubstr("particle " + std::to_string(report.failure.particle) + " ("));
    EXPECT_THAT(report.error, HasSubstr("spring to " + std::to_string(report.failure.other)));
    rk4.apply(command::Reset{});
    EXPECT_EQ(rk4.report().failure.particle, -1) << "after a reset";
    EXPECT_THAT(after_a_while("fails_penalty", load_scene("fails_penalty")).report().error,
                HasSubstr(". Time step is 25.3 x the limit of 0.0123 ms. First: particle "));
    EXPECT_THAT(after_a_while("fails_explicit_euler", load_scene("fails_explicit_euler")).report().error,
                HasSubstr(". No time step of explicit_euler that may be set is stable here: "));
}

TEST(FailingScenes, OfXpbdWithOneIterationIsFarTooSoft) {
    const auto stretch_of_xpbd = [](const std::string& iterations) {
        Simulation simulation = shipped_simulation("fails_xpbd", {"iterations=" + iterations});
        make_steps(simulation, 59);
        EXPECT_EQ(simulation.report().status, Status::Ok);
        return simulation.view().report->stretch;
    };
    EXPECT_GT(stretch_of_xpbd("1"), 1);
    EXPECT_LT(stretch_of_xpbd("500"), 0.1);
}

TEST(FailingScenes, RunWithTheClampedHessianOrAnotherMethod) {
    for (const auto& [name, cure] : {std::pair("fails_backward_euler", "hessian=clamped"),
                                     {"fails_implicit_midpoint", "hessian=clamped"},
                                     {"fails_explicit_euler", "integrator=symplectic_euler"}}) {
        EXPECT_EQ(after_a_while(name, shipped_settings(name, {cure})).report().status, Status::Ok) << name;
    }
}

TEST(LongFailingScenes, RunAtNineTenthsOfTheLongestStep) {
    for (const std::string name : {"fails_symplectic_euler", "fails_rk4", "fails_penalty"}) {
        Settings settings = load_scene(name);
        const double longest = Simulation(name, settings).longest_step();
        EXPECT_LT(longest, settings.solver.dt) << name;
        settings.solver.dt = 0.9 * longest;
        Simulation simulation(name, settings);
        run_until(simulation, 0.4);
    }
}

}  // namespace
}  // namespace drape
