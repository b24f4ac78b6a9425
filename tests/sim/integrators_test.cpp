// Every integrator in whole scenes, with contact.

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/small_scene.h"

namespace drape {
namespace {

class EveryIntegrator : public ::testing::TestWithParam<IntegratorKind> {};

TEST_P(EveryIntegrator, MeetsTheBallAlike) {
    // In as many parts as explicit Euler asks for
    Simulation reference = small_simulation({"integrator=rk4"}),
               simulation = small_simulation({"integrator=" + name_of(GetParam()), "on_unstable=substep"});
    double deepest = 0;
    std::int64_t contacts = 0;
    for (int step = 0; step < 1024; ++step) {
        reference.step(), simulation.step();
        deepest = std::max(deepest, simulation.report().penetration);
        contacts += simulation.report().contacts;
    }
    ASSERT_EQ(simulation.report().status, Status::Ok) << simulation.report().error;
    EXPECT_GT(contacts, 1000);
    EXPECT_LT(deepest, 1e-3);
    const Points &x = simulation.cloths()[0].state.x, &exact = reference.cloths()[0].state.x;
    EXPECT_LT(std::sqrt((x - exact).squaredNorm() / static_cast<Real>(x.rows())), 0.05);
}

TEST_P(EveryIntegrator, GivesAClothTheSameBitsWhateverBodyIsFarAway) {
    Settings alone = small_settings();
    alone.balls.clear();
    alone.solver.integrator = GetParam();
    alone.contact.response = ResponseKind::Hybrid;
    Settings with_ball = alone;
    BallSettings& ball = with_ball.balls.emplace_back();
    ball.motion = BallMotion::Free;
    ball.position = Vec3(0, 100, 0);
    ball.mass = Real(0.001);
    SolidSettings& box = with_ball.solids.emplace_back();
    box.position = Vec3(50, 0, 0);
    Simulation first("alone", std::move(alone)), second("with a ball", std::move(with_ball));
    for (int step = 0; step < 50; ++step) first.step(), second.step();
    EXPECT_EQ(first.cloths()[0].state.x, second.cloths()[0].state.x);
    EXPECT_EQ(first.cloths()[0].state.v, second.cloths()[0].state.v);
}

/// The one that remembers the step before.
INSTANTIATE_TEST_SUITE_P(One, EveryIntegrator, ::testing::Values(IntegratorKind::Bdf2));
INSTANTIATE_TEST_SUITE_P(Nightly, EveryIntegrator, ::testing::ValuesIn(methods_but({})), name_of_param);

}  // namespace
}  // namespace drape
