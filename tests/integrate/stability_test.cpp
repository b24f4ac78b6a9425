#include "drape/integrate/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace drape {
namespace {

/// A free cloth without gravity: small waves on it are all that moves.
ClothModel free_cloth(Real damping) {
    ClothParameters parameters;
    parameters.particles = {24, 24};
    parameters.width = Real(1.5);
    parameters.structural = {1000, damping};
    parameters.shear = {500, damping};
    parameters.bend = {100, damping};
    ClothModel model = make_cloth_model(parameters);
    model.gravity.setZero();
    return model;
}

/// True if an in-plane ripple of a micrometre becomes many times as fast as it was in the first steps.
bool ripple_grows(const ClothModel& model, IntegratorKind kind, Real h) {
    constexpr int first_steps = 300, steps = 6000;
    constexpr Real many = 5;
    ClothParameters parameters;
    parameters.particles = model.grid;
    parameters.width = model.hx * static_cast<Real>(model.grid.cell_columns());
    parameters.height = model.hy * static_cast<Real>(model.grid.cell_rows());
    ClothState state = make_rest_state(parameters);
    std::mt19937 random(2);
    std::uniform_real_distribution<Real> ripple(Real(-1e-6), Real(1e-6));
    for (Eigen::Index p = 0; p < state.x.rows(); ++p) {
        state.x(p, 0) += ripple(random);
        state.x(p, 2) += ripple(random);
    }
    const auto integrator = make_integrator({.kind = kind}, model.grid);
    Real before = 0;
    for (int step = 0; step < steps; ++step) {
        integrator->step(model, state, h);
        if (step < first_steps) before = std::max(before, state.v.norm());
        if (!(state.v.norm() <= many * before)) return true;
    }
    return false;
}

class StabilityLimit : public testing::TestWithParam<std::tuple<IntegratorKind, Real>> {
protected:
    IntegratorKind kind() const { return std::get<0>(GetParam()); }
    ClothModel model() const { return free_cloth(std::get<1>(GetParam())); }
};

TEST_P(StabilityLimit, LetsNoSmallWaveGrowJustBelow) {
    EXPECT_FALSE(ripple_grows(model(), kind(), Real(0.98) * estimated_stable_step(model(), kind())));
}

TEST_P(StabilityLimit, LetsSmallWavesGrowNotFarAbove) {
    EXPECT_TRUE(ripple_grows(model(), kind(), Real(1.15) * estimated_stable_step(model(), kind())));
}

INSTANTIATE_TEST_SUITE_P(AllMethods, StabilityLimit,
                         testing::Combine(testing::Values(IntegratorKind::ExplicitEuler,
                                                          IntegratorKind::SymplecticEuler,
                                                          IntegratorKind::VelocityVerlet, IntegratorKind::Rk4),
                                          testing::Values(Real(0.05), Real(0.3))),
                         [](const auto& method) {
                             return std::string(name_of(std::get<0>(method.param))) +
                                    (std::get<1>(method.param) < Real(0.1) ? "_light" : "_heavy");
                         });

TEST(StableStep, OfAnUndampedChainIsTwoOverItsHighestFrequency) {
    ClothModel model = free_cloth(0);
    model.shear = model.bend = {0, 0};
    model.drag = 0;
    const Real highest = std::sqrt(4 * model.structural.stiffness / model.particle_mass);
    EXPECT_NEAR(estimated_stable_step(model, IntegratorKind::SymplecticEuler) * highest, 2, 1e-3);
    EXPECT_NEAR(estimated_stable_step(model, IntegratorKind::VelocityVerlet) * highest, 2, 1e-3);
    EXPECT_NEAR(estimated_stable_step(model, IntegratorKind::Rk4) * highest, 2 * std::sqrt(Real(2)), 1e-3);
}

TEST(StableStep, OfExplicitEulerIsNoneWithoutDamping) {
    ClothModel model = free_cloth(0);
    model.drag = 0;
    const Real of_symplectic = estimated_stable_step(model, IntegratorKind::SymplecticEuler);
    EXPECT_LT(estimated_stable_step(model, IntegratorKind::ExplicitEuler), Real(1e-3) * of_symplectic);
}

TEST(StableStep, IsUnlimitedWithoutSprings) {
    ClothModel model = free_cloth(0);
    model.structural = model.shear = model.bend = {0, 0};
    EXPECT_TRUE(std::isinf(estimated_stable_step(model, IntegratorKind::SymplecticEuler)));
}

}  // namespace
}  // namespace drape
