#include <gmock/gmock.h>

#include "drape/base/input_error.h"
#include "drape/sim/scene.h"
#include "sim/scene_lists.h"
#include "sim/small_scene.h"
#include "support/exact_distance.h"
#include "support/sanitized.h"

namespace drape {
namespace {

Real deepest_in_any_ball(const Simulation& simulation) {
    Real deepest = -1;
    for (const Cloth& cloth : simulation.cloths()) {
        for (const Ball& ball : simulation.balls()) {
            deepest = std::max(deepest, deepest_triangle(cloth.model.grid, cloth.state.x, ball) / ball.radius);
        }
    }
    return deepest;
}

class ShippedScene : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScene, RunsForSecondsInNoDoubtAndStretchesNoFurtherThanCloth) {
    Simulation simulation(GetParam(), load_scene(GetParam()));
    const int steps_of_a_tenth = static_cast<int>(std::lround(0.1 / simulation.settings().solver.dt));
    const Cost cost = cost_of(simulation.settings());
    const int tenths = cost == Cost::Large    ? (test::sanitized ? 1 : 4)
                       : cost == Cost::Costly ? (test::sanitized ? 3 : 6)
                                              : (test::sanitized ? 15 : 100);
    double largest = 0;
    for (int tenth = 0; tenth < tenths; ++tenth) {
        make_steps(simulation, steps_of_a_tenth);
        const StepReport& report = *simulation.view().report;
        ASSERT_EQ(report.status, Status::Ok) << report.trouble;
        ASSERT_FALSE(in_doubt(report)) << simulation.run_warning();
        ASSERT_LT(report.stretch, 0.08) << "at " << report.time << " s";
        largest = std::max(largest, report.stretch);
        ASSERT_LT(deepest_in_any_ball(simulation), 1e-3) << "of the radius, at " << report.time << " s";
    }
    EXPECT_GT(largest, 0.001) << "nothing hangs or rests on anything";
    EXPECT_NEAR(simulation.report().time, tenths / 10.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Long, ShippedScene, testing::ValuesIn(scenes_that_fail(false)),
                         [](const auto& scene) { return scene.param; });

TEST(LongDropScene, ComesToRestOnTheBallAndNoTriangleEntersIt) {
    Simulation simulation("drop", load_scene("drop"));
    const Real dt = simulation.settings().solver.dt;
    const Cloth& cloth = simulation.cloths()[0];
    const Ball& ball = simulation.balls()[0];
    make_steps(simulation, static_cast<int>(std::lround(3 / dt)));
    const auto watch = [&](double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / dt)); ++i) {
            simulation.step();
            const Real depth = deepest_triangle(cloth.model.grid, cloth.state.x, ball);
            ASSERT_LT(depth, 1e-3 * ball.radius) << "at " << simulation.report().time << " s";
        }
    };
    watch(2);
    EXPECT_LT(simulation.view().report->rms_speed, 1e-3) << "m/s after five seconds";
    watch(1);
    EXPECT_LT(simulation.view().report->rms_speed, 1e-3);
    EXPECT_GT(simulation.report().contacts, 50) << "it lies on the ball";
    EXPECT_GT(cloth.state.x.col(1).maxCoeff(), ball.centre[1] + ball.radius - 1e-3) << "it has not fallen off";
}

}  // namespace
}  // namespace drape
