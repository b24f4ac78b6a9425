// A cloth on a ball, and a ball on a cloth, come to rest; what rests falls asleep, and its books stay.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "drape/integrate/stability.h"
#include "sim/small_scene.h"
#include "support/exact_distance.h"

namespace drape {
namespace {

/// `drop` of few particles, with a ledger.
Simulation small_drop(IntegratorKind integrator, ResponseKind response) {
    Settings settings = shipped_settings("drop", {"ledger=true", "sleep_speed=2e-5"});  // a tenth of the default
    ClothParameters& cloth = settings.cloths[0];
    cloth.drag *= static_cast<Real>(cloth.particles.particles()) / 81;  // the same on the whole cloth
    cloth.particles = {9, 9};
    settings.contact.response = response;
    settings.solver.integrator = integrator;
    settings.solver.dt = has_step_limit(integrator) ? 3.125e-4 : 1.0 / 60;
    return {"drop", std::move(settings)};
}

double rms_motion(const Simulation& simulation) {
    return rms_motion(simulation.cloths(), simulation.settings().solver.dt);
}

/// Runs until the scene sleeps.
/// @return RMS speed in the step before [m/s]
double run_to_sleep(Simulation& simulation, double longest) {
    double speed = 0;
    while (!simulation.report().asleep && simulation.report().status == Status::Ok &&
           simulation.report().time < longest) {
        speed = rms_motion(simulation);
        simulation.step();
    }
    return speed;
}

/// The report with its energy balance.
StepReport books(Simulation& simulation) {
    static_cast<void>(simulation.view());
    return simulation.report();
}

using RestCase = std::tuple<IntegratorKind, ResponseKind>;

class RestOnABall : public testing::TestWithParam<RestCase> {};

/// Every method but explicit Euler, each with these responses.
std::vector<RestCase> rest_cases(const std::vector<ResponseKind>& responses) {
    std::vector<RestCase> cases;
    for (const IntegratorKind integrator : methods_but({IntegratorKind::ExplicitEuler})) {
        for (const ResponseKind response : responses) cases.emplace_back(integrator, response);
    }
    return cases;
}

/// What falls asleep at a tenth of the usual speed. Under penalties and the hybrid velocities do not: see below.
INSTANTIATE_TEST_SUITE_P(Long, RestOnABall,
                         testing::Values(RestCase{IntegratorKind::SymplecticEuler, ResponseKind::Projection}),
                         name_of_param);
INSTANTIATE_TEST_SUITE_P(Nightly, RestOnABall,
                         testing::ValuesIn(rest_cases({ResponseKind::Projection, ResponseKind::Impulse})),
                         name_of_param);

TEST_P(RestOnABall, IsReachedAndNothingIsBookedAfterIt) {
    const auto [integrator, response] = GetParam();
    Simulation simulation = small_drop(integrator, response);
    const double speed = run_to_sleep(simulation, 10);
    ASSERT_TRUE(simulation.report().asleep) << speed << " m/s";
    EXPECT_LT(speed, 3e-4);
    const StepReport then = books(simulation);
    make_steps(simulation, 100);
    const StepReport now = books(simulation);
    for (const std::string_view row :
         {"damping_loss", "drag_loss", "contact_loss", "integrator_loss", "ball_work", "hand_work", "energy"})
        EXPECT_EQ(figure(now, row), figure(then, row)) << row;
}

class CreepOnABall : public testing::TestWithParam<RestCase> {};

INSTANTIATE_TEST_SUITE_P(Long, CreepOnABall,
                         testing::Values(RestCase{IntegratorKind::SymplecticEuler, ResponseKind::Hybrid}),
                         name_of_param);
INSTANTIATE_TEST_SUITE_P(Nightly, CreepOnABall,
                         testing::ValuesIn(rest_cases({ResponseKind::Penalty, ResponseKind::Hybrid})), name_of_param);

TEST_P(CreepOnABall, StaysBelowItsBound) {
    const auto [integrator, response] = GetParam();
    Simulation simulation = small_drop(integrator, response);
    send(simulation, "set solver.sleep_speed=0");
    run_until(simulation, 10);
    for (int k = 0; k < 20; ++k) {
        simulation.step();
        EXPECT_LT(rms_motion(simulation), 3e-4) << simulation.report().time << " s";
    }
}

class FirstTouch : public testing::TestWithParam<RestCase> {};

std::vector<RestCase> cases_of_long_steps() {
    std::vector<RestCase> cases = rest_cases({ResponseKind::Penalty, ResponseKind::Hybrid});
    std::erase_if(cases, [](const RestCase& one) { return has_step_limit(std::get<0>(one)); });
    return cases;
}

INSTANTIATE_TEST_SUITE_P(OneMethod, FirstTouch,
                         testing::Values(RestCase{IntegratorKind::BackwardEuler, ResponseKind::Penalty}),
                         name_of_param);
INSTANTIATE_TEST_SUITE_P(Nightly, FirstTouch, testing::ValuesIn(cases_of_long_steps()), name_of_param);

/// In a step of 1/60 s that is not divided, a penalty is pressed in so deep that it throws the cloth off.
TEST_P(FirstTouch, GivesNoEnergy) {
    const auto [integrator, response] = GetParam();
    Simulation simulation = small_drop(integrator, response);
    const double start = books(simulation).energy.total();
    bool touched = false;
    for (int step = 0; step < 60; ++step) {
        simulation.step();
        touched = touched || simulation.report().contacts > 0;
        EXPECT_LT(books(simulation).energy.total(), 1.001 * start) << simulation.report().time << " s";
    }
    EXPECT_TRUE(touched);
}

struct ShippedRest {
    const char* scene;
    double after;  ///< [s]
    IntegratorKind integrator;
    ResponseKind response = ResponseKind::Projection;
};

std::string name_of_rest(const testing::TestParamInfo<ShippedRest>& rest) {
    const auto [scene, after, integrator, response] = rest.param;
    const std::string name = std::string(scene) + "_" + std::string(name_of(integrator));
    return response == ResponseKind::Projection ? name : name + "_" + std::string(name_of(response));
}

std::vector<ShippedRest> shipped_rests() {
    using enum IntegratorKind;
    std::vector<ShippedRest> rests;
    for (const IntegratorKind kind : {BackwardEuler, Bdf2, Xpbd, ProjectiveDynamics})
        rests.push_back({"drop", 8, kind});
    for (const IntegratorKind kind : {ImplicitMidpoint, VelocityVerlet, Rk4, DormandPrince}) {
        rests.push_back({"drop", 5, kind});
    }
    for (std::size_t r = 0, all = rests.size(); r < all; ++r) rests.push_back({"trampoline", 12, rests[r].integrator});
    rests.push_back({"drop", 8, BackwardEuler, ResponseKind::Impulse});
    for (const IntegratorKind kind : {Rk4, DormandPrince}) rests.push_back({"drop", 5, kind, ResponseKind::Impulse});
    rests.push_back({"trampoline", 12, Xpbd, ResponseKind::Impulse});
    return rests;
}

class RestOfShippedScenes : public testing::TestWithParam<ShippedRest> {};

TEST_P(RestOfShippedScenes, IsReached) {
    const auto [scene, after, integrator, response] = GetParam();
    Settings settings = shipped_settings(scene, {"sleep_speed=0"});
    settings.solver.integrator = integrator;
    if (!has_step_limit(integrator)) settings.solver.dt = 1.0 / 120;
    settings.contact.response = response;
    Simulation simulation(scene, std::move(settings));
    run_until(simulation, after);
    for (int k = 0; k < 20; ++k) {
        simulation.step();
        EXPECT_LT(rms_motion(simulation), 3e-4) << simulation.report().time << " s";
        // A ball that rocks in its hollow comes to rest later than the cloth
        EXPECT_LT(simulation.balls()[0].velocity.norm(), 1e-3) << simulation.report().time << " s";
    }
    EXPECT_GT(simulation.report().contacts, 0);
}

/// On the ball of `drop` cloth would rock under the methods of half a share if contacts were given all of what they
/// had.
INSTANTIATE_TEST_SUITE_P(Long, RestOfShippedScenes,
                         testing::Values(ShippedRest{"drop", 8, IntegratorKind::SymplecticEuler}), name_of_rest);
INSTANTIATE_TEST_SUITE_P(Nightly, RestOfShippedScenes, testing::ValuesIn(shipped_rests()), name_of_rest);

/// The push of the cloth on the ball, averaged over a second [N].
Real mean_push(Simulation& simulation) {
    const double start = simulation.report().time;
    Real push = 0;
    run_until(simulation, start + 1, [&] {
        for (const ContactRow& contact : simulation.contacts()) {
            push -= contact.impulse.normal * contact.normal.y() + contact.impulse.friction.y();
        }
    });
    return push / static_cast<Real>(simulation.report().time - start);
}

TEST(LongRestInATrampoline, IsReachedByTheShippedSceneThatThrewItsBallBackAndCostsNothing) {
    Settings settings = load_scene("trampoline");
    const Real sleep_speed = std::exchange(settings.solver.sleep_speed, Real(0));
    Simulation simulation("trampoline", std::move(settings));
    const Cloth& cloth = simulation.cloths()[0];
    const Ball& ball = simulation.balls()[0];
    const Real sheet = cloth.state.x(0, 1);
    run_until(simulation, 0.6);
    EXPECT_GT(ball.velocity.y(), 0.5) << "thrown back";
    double fast = simulation.report().time;  // when it last was
    while (simulation.report().time - fast < 0.5 && simulation.report().time < 15) {
        simulation.step();
        if (rms_motion(simulation) > 3e-4) fast = simulation.report().time;
    }
    EXPECT_LT(fast, 12);
    EXPECT_LT((ball.centre - Vec3(0, sheet, 0)).norm(), 0.1) << "in the middle of the sheet";
    EXPECT_GT(ball.centre.y() - ball.radius, cloth.state.x.col(1).minCoeff() - 1e-3) << "not below it";
    EXPECT_LT(deepest_triangle(cloth.model.grid, cloth.state.x, ball), 1e-3 * ball.radius);
    EXPECT_LT(cloth.state.x.col(1).minCoeff(), sheet - 0.03) << "which sags";
    const Real weight = simulation.settings().balls[0].mass * Real(9.81);
    EXPECT_NEAR(mean_push(simulation), weight, 0.02 * weight);
    send(simulation, "set solver.sleep_speed=" + std::to_string(sleep_speed));
    run_to_sleep(simulation, simulation.report().time + 0.6);
    ASSERT_TRUE(simulation.report().asleep);
    EXPECT_EQ(ball.velocity, Vec3(0, 0, 0));
    const std::uint64_t hash = simulation.hash();
    simulation.step();
    EXPECT_EQ(simulation.hash(), hash);
    EXPECT_EQ(simulation.report().solve.force_evaluations, 0);
}

/// By their velocities: what pairs displace by in each substep goes back and forth by a third of a micrometre.
TEST(LongRest, OfSheetsThatLieOnEachOtherIsSlowerThanHalfAMillimetreASecond) {
    // Few particles, and so much drag that it soon rests
    Simulation simulation =
        shipped_simulation("stack", {"cloth.particles=16,16", "cloth.drag=3.3e-2", "dt=4e-4", "sleep_speed=0"});
    run_until(simulation, 4.0);
    double fastest = 0;
    run_until(simulation, 4.2, [&] { fastest = std::max(fastest, books(simulation).rms_speed); });
    EXPECT_GT(simulation.report().pairs, 100);
    EXPECT_LT(fastest, 0.5e-3);
}

}  // namespace
}  // namespace drape
