// The fail-safe where it has to act: what would cross without it, by exact arithmetic, never does with it.

#include <gmock/gmock.h>

#include "drape/sim/simulation.h"
#include "lab/contact/contact_trial.h"
#include "support/sanitized.h"
#include "support/scene_crossings.h"

namespace drape {
namespace {

/// What an exact count has seen after every step.
struct ExactTally {
    int crossed_steps = 0;
    std::int64_t held_back = 0;
};

/// A sheet is thrown at another, with the fail-safe or without.
ExactTally throw_at_sheet(const ContactScene& scene, FailSafe fail_safe) {
    constexpr int steps = 24;
    ContactTrial trial(scene.settings, scene.start);
    test::SceneCrossings oracle;
    ExactTally tally;
    for (int step = 0; step < steps; ++step) {
        tally.held_back += make_step(trial, fail_safe, Real(1) / 240).at("held_back");
        const std::int64_t crossings = oracle.count(trial.cloths);
        tally.crossed_steps += crossings > 0 ? 1 : 0;
        EXPECT_EQ(meeting_of(trial).crossings > 0, crossings > 0) << step;
    }
    return tally;
}

/// A sheet's speed [m/s] and thickness [m].
class FailSafeOfThrownSheets : public testing::TestWithParam<std::pair<double, double>> {};

INSTANTIATE_TEST_SUITE_P(Long, FailSafeOfThrownSheets, testing::Values(std::pair(8, 1.25e-4)));
INSTANTIATE_TEST_SUITE_P(Nightly, FailSafeOfThrownSheets, testing::Values(std::pair(8, 2.5e-4), std::pair(5, 5e-5)));

TEST_P(FailSafeOfThrownSheets, LeavesNoCrossing) {
    const auto [speed, thickness] = GetParam();
    const ContactScene scene = throw_sheet(static_cast<Real>(speed), static_cast<Real>(thickness));
    const ExactTally with = throw_at_sheet(scene, FailSafe::Zones), without = throw_at_sheet(scene, FailSafe::None);
    EXPECT_EQ(with.crossed_steps, 0);
    EXPECT_GT(with.held_back, 0);
    EXPECT_GT(without.crossed_steps, 0);
    EXPECT_EQ(without.held_back, 0);
}

/// A sheet in pleats, the one above the other, which falls on the ground at 10 m/s.
ContactScene pleated_sheet() {
    constexpr Real pleat = Real(0.25), slope = Real(0.06);
    ContactScene scene;
    Settings& settings = scene.settings;
    settings.cloths.clear();
    ClothParameters cloth;
    cloth.particles = {13, 25};
    cloth.bend = {1, Real(0.001)};
    settings.cloths.push_back(cloth);
    ClothState start = make_rest_state(cloth);
    for (Eigen::Index p = 0; p < start.x.rows(); ++p) {
        const Real way = start.x(p, 2), pleats = std::floor(way / pleat), rest = way - pleats * pleat;
        const bool back = static_cast<int>(pleats) % 2 == 1;
        start.x.row(p) << start.x(p, 0), slope * way + Real(0.02), back ? pleat - rest : rest;
    }
    start.v.rowwise() = Vec3(Real(0.3), -10, 0).transpose();
    scene.start.states.push_back(start);
    settings.contact.self = true;
    settings.contact.thickness = Real(2e-4);
    settings.ground.solid = true;
    settings.ground.height = 0;
    settings.solver.integrator = IntegratorKind::BackwardEuler;
    settings.solver.dt = 1.0 / 240;
    return scene;
}

ExactTally let_fall(const ContactScene& scene, bool self) {
    Settings settings = scene.settings;
    settings.contact.self = self;
    Simulation simulation("pleats", std::move(settings), scene.start);
    test::SceneCrossings oracle;
    ExactTally tally;
    const int steps = test::sanitized ? 12 : 48;
    for (int step = 0; step < steps && simulation.report().status == Status::Ok; ++step) {
        simulation.step();
        EXPECT_EQ(simulation.report().status, Status::Ok) << simulation.report().error;
        tally.held_back += simulation.report().failsafe_particles;
        tally.crossed_steps += oracle.count(simulation.cloths()) > 0 ? 1 : 0;
    }
    return tally;
}

TEST(FailSafe, LeavesNoCrossingInASheetInPleatsThatFallsOnTheGround) {
    const ContactScene scene = pleated_sheet();
    const ExactTally with = let_fall(scene, true), without = let_fall(scene, false);
    EXPECT_EQ(with.crossed_steps, 0);
    EXPECT_GT(with.held_back, 0);
    EXPECT_GT(without.crossed_steps, 0);
}

}  // namespace
}  // namespace drape
