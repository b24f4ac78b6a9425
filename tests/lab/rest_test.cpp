#include <gtest/gtest.h>

#include <algorithm>

#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "lab/experiments.h"
#include "lab/needs/needs.h"

namespace drape {
namespace {

/// The settings of a quick case.
Settings quick_drop(const Row& row, IntegratorKind integrator) {
    Settings settings = on_grid(load_scene("drop"), {9, 9});
    settings.contact.self = false;
    settings.solver.integrator = integrator;
    settings.solver.dt = row.number("step_s");
    return settings;
}

TEST(RestCase, FallsAsleepWhenTheSceneDoes) {
    const Row row = rest_experiment().cases(true)[1]().front();
    EXPECT_EQ(row.number("step_s"), 3.125e-4);
    Simulation simulation("drop", quick_drop(row, IntegratorKind::SymplecticEuler));
    while (!simulation.report().asleep && simulation.report().time < 10) simulation.step();
    EXPECT_EQ(row.number("asleep_s"), simulation.report().time);
    EXPECT_LT(row.number("speed_before_m_per_s"), 2e-4);
    EXPECT_LT(row.number("speed_after_m_per_s"), row.number("speed_before_m_per_s"));
}

TEST(LongDriftCase, IsHowFarTheFarthestParticleWasFromWhereItRested) {
    const Row row = rest_experiment().cases(true)[21]().front();
    Settings settings = quick_drop(row, IntegratorKind::VelocityVerlet);
    settings.solver.sleep_speed = 0;
    Simulation simulation("drop", settings);
    const auto positions_at = [&](double time) {
        while (simulation.report().time < time - 1e-6) simulation.step();
        return simulation.cloths()[0].state.x;
    };
    const Points start = positions_at(8);
    double farthest = 0;
    for (const double time : {9.0, 10.0}) {
        const Points moved = positions_at(time) - start;
        farthest = std::max(farthest, static_cast<double>(moved.rowwise().norm().maxCoeff()));
    }
    EXPECT_EQ(row.number("drift_m"), farthest);
    EXPECT_GT(farthest, 0);
    EXPECT_LT(farthest, 1e-4);
    EXPECT_EQ(row.word("end"), "awake");
}

}  // namespace
}  // namespace drape
