#include "drape/integrate/integrator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drape/model/energy.h"
#include "integrate/damped_sheet.h"
#include "support/allocations.h"

namespace drape {
namespace {

constexpr IntegratorKind all_kinds[] = {IntegratorKind::ExplicitEuler, IntegratorKind::SymplecticEuler,
                                        IntegratorKind::VelocityVerlet, IntegratorKind::Rk4};

using test::Sheet;

ClothState after(IntegratorKind kind, const ClothModel& model, const ClothState& state, Real time, int steps) {
    return test::after({.kind = kind}, model, state, time, steps);
}

void expect_order(IntegratorKind kind, Real order) {
    for (const Real observed : test::observed_orders({.kind = kind})) {
        EXPECT_GT(observed, order - 0.15) << name_of(kind);
        EXPECT_LT(observed, order + 0.25) << name_of(kind);
    }
}

TEST(Integrators, ReachTheirOrders) {
    expect_order(IntegratorKind::ExplicitEuler, 1);
    expect_order(IntegratorKind::SymplecticEuler, 1);
    expect_order(IntegratorKind::VelocityVerlet, 2);
    expect_order(IntegratorKind::Rk4, 4);
}

TEST(Integrators, KeepPinnedParticlesToTheBit) {
    const Sheet sheet;
    for (const IntegratorKind kind : all_kinds) {
        const ClothState state = after(kind, sheet.model, sheet.start, 0.1, 100);
        for (int p = 0; p < sheet.model.grid.particles(); ++p) {
            if (!sheet.model.pinned(p)) continue;
            EXPECT_EQ(state.x.row(p), sheet.start.x.row(p)) << name_of(kind);
        }
    }
}

TEST(Integrators, MakeTheStepsOfTheDesign) {
    // One free particle under gravity and drag alone: a = g - (b/m) v, so that each step can be written down
    ClothParameters parameters;
    parameters.particles = {2, 2};
    parameters.structural = parameters.shear = parameters.bend = {};
    parameters.drag = 0.02;
    const ClothModel model = make_cloth_model(parameters);
    ClothState start = make_rest_state(parameters);
    start.v.col(1).setConstant(3);
    const Real h = 0.1, rate = parameters.drag / model.particle_mass;
    const auto a = [&](Real v) { return -9.81 - rate * v; };

    const ClothState explicit_euler = after(IntegratorKind::ExplicitEuler, model, start, h, 1);
    EXPECT_DOUBLE_EQ(explicit_euler.x(0, 1), h * 3);
    EXPECT_DOUBLE_EQ(explicit_euler.v(0, 1), 3 + h * a(3));

    const ClothState symplectic = after(IntegratorKind::SymplecticEuler, model, start, h, 1);
    EXPECT_DOUBLE_EQ(symplectic.x(0, 1), h * (3 + h * a(3)));

    const ClothState verlet = after(IntegratorKind::VelocityVerlet, model, start, h, 1);
    EXPECT_DOUBLE_EQ(verlet.x(0, 1), h * 3 + h * h / 2 * a(3));
    EXPECT_DOUBLE_EQ(verlet.v(0, 1), 3 + h / 2 * (a(3) + a(3 + h * a(3))));

    const ClothState rk4 = after(IntegratorKind::Rk4, model, start, h, 1);
    const Real limit = -9.81 / rate, z = -rate * h;
    EXPECT_NEAR(rk4.v(0, 1), limit + (3 - limit) * (1 + z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24), 1e-13);
}

TEST(Integrators, ConserveMomentumWithoutGravity) {
    Sheet sheet;
    sheet.parameters.pinned.kind = Pins::Kind::None;
    sheet.parameters.drag = 0;
    sheet.model = make_cloth_model(sheet.parameters);
    sheet.model.gravity.setZero();
    const auto momentum = [](const ClothState& s) { return s.v.colwise().sum().eval(); };
    for (const IntegratorKind kind : all_kinds) {
        const ClothState state = after(kind, sheet.model, sheet.start, 0.2, 400);
        EXPECT_LT((momentum(state) - momentum(sheet.start)).norm(), 1e-12) << name_of(kind);
    }
}

TEST(SymplecticMethods, KeepTheEnergyBounded) {
    Sheet sheet;
    sheet.undamp();
    const Real before = compute_energy(sheet.model, sheet.start, Kernels::Vector).total();
    for (const IntegratorKind kind : {IntegratorKind::SymplecticEuler, IntegratorKind::VelocityVerlet}) {
        const ClothState state = after(kind, sheet.model, sheet.start, 20, 20000);
        EXPECT_NEAR(compute_energy(sheet.model, state, Kernels::Vector).total(), before, 0.05 * std::abs(before))
            << name_of(kind);
    }
}

TEST(Integrators, AllocateNothingInAStep) {
    const Sheet sheet;
    for (const IntegratorKind kind : all_kinds) {
        const auto integrator = make_integrator({.kind = kind}, sheet.model.grid);
        ClothState state = sheet.start;
        const auto before = test::allocations();
        for (int step = 0; step < 3; ++step) integrator->step(sheet.model, state, 1e-3);
        EXPECT_EQ(test::allocations(), before) << name_of(kind);
    }
}

TEST(Integrators, HaveANameEach) {
    EXPECT_EQ(name_of(IntegratorKind::ExplicitEuler), "explicit_euler");
    EXPECT_EQ(name_of(IntegratorKind::SymplecticEuler), "symplectic_euler");
    EXPECT_EQ(name_of(IntegratorKind::VelocityVerlet), "velocity_verlet");
    EXPECT_EQ(name_of(IntegratorKind::Rk4), "rk4");
}

}  // namespace
}  // namespace drape
