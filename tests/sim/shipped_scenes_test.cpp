#include <gtest/gtest.h>

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
    // Cloth on cloth and on meshes takes long, and so do many particles
    const Settings& settings = simulation.settings();
    const bool large = settings.cloths[0].particles.particles() > 10'000;
    const bool costly = settings.contact.self || !settings.solids.empty();
    const int tenths = large    ? (test::sanitized ? 1 : 4)
                       : costly ? (test::sanitized ? 3 : 6)
                                : (test::sanitized ? 15 : 30);
    double largest = 0;
    for (int tenth = 0; tenth < tenths; ++tenth) {
        make_steps(simulation, steps_of_a_tenth);
        const StepReport& report = *simulation.view().report;
        ASSERT_EQ(report.status, Status::Ok) << report.error;
        ASSERT_FALSE(in_doubt(report)) << simulation.run_warning();
        ASSERT_LT(report.stretch, 0.08) << "at " << report.time << " s";
        largest = std::max(largest, report.stretch);
        ASSERT_LT(deepest_in_any_ball(simulation), 1e-3) << "of the radius, at " << report.time << " s";
    }
    EXPECT_GT(largest, 0.001) << "nothing hangs or rests on anything";
    EXPECT_NEAR(simulation.report().time, tenths / 10.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Long, ShippedScene, testing::ValuesIn(scenes_that_fail(false)), name_of_param);

}  // namespace
}  // namespace drape
