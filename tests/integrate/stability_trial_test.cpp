// Steps that are tried: limits that are measured, and methods that have none, or are said to have none.

#include "drape/integrate/stability_trial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drape/integrate/stability.h"

namespace drape {
namespace {

/// A free flat sheet at rest, without gravity: the state that is tried is the one that was looked at.
struct TrialSheet {
    ClothModel model;
    ClothState state;

    TrialSheet(int side, Real stiffness, Real damping) {
        ClothParameters parameters;
        parameters.particles = {side, side};
        parameters.structural = parameters.shear = parameters.bend = {stiffness, damping};
        parameters.drag = 0;
        model = make_cloth_model(parameters);
        model.gravity.setZero();
        state = make_rest_state(parameters);
    }

    [[nodiscard]] Real predicted(IntegratorKind kind) const {
        return predicted_limit(model, state, kind, Kernels::Vector).step;
    }
};

TEST(LongMeasuredLimit, IsThePredictedOneWithinThreePercent) {
    const TrialSheet sheets[] = {{12, 1e4, 0}, {12, 1e4, 0.1}, {12, 1e4, 1}, {16, 1e2, 0}, {30, 1e6, 0}};
    for (const TrialSheet& sheet : sheets) {
        for (const IntegratorKind kind :
             {IntegratorKind::SymplecticEuler, IntegratorKind::VelocityVerlet, IntegratorKind::Rk4}) {
            const Real predicted = sheet.predicted(kind);
            const Real measured = measured_limit(sheet.model, sheet.state, {.integrator = kind}, Real(0.7) * predicted);
            EXPECT_NEAR(measured / predicted, 1, 0.03) << name_of(kind) << ", " << sheet.model.grid.nx
                                                       << " a side, damping " << sheet.model.structural.damping;
        }
    }
}

TEST(LongMeasuredLimit, DoesNotDependOnWhereTheSearchStarts) {
    const TrialSheet sheet(8, 1e3, 0);
    const auto measured = [&](Real guess) {
        return measured_limit(sheet.model, sheet.state, {.integrator = IntegratorKind::SymplecticEuler}, guess);
    };
    const Real from_below = measured(Real(1e-4));
    // From above, and where nothing is guessed
    for (const Real guess : {Real(0.5), Real(0)}) EXPECT_NEAR(measured(guess) / from_below, 1, 0.01);
}

TEST(LongMeasuredLimit, OfExplicitEulerIsTheOneThatItsGrowthFromNoiseTakes) {
    for (const Real damping : {0.0, 0.1}) {
        const TrialSheet sheet(12, 1e4, damping);
        const StepLimit fastest =
            predicted_limit(sheet.model, sheet.state, IntegratorKind::SymplecticEuler, Kernels::Vector);
        for (const int steps : {3000, 12000}) {
            const Real expected = observable_limit_of_explicit_euler(sheet.model, sheet.state, fastest.omega,
                                                                     fastest.zeta, Kernels::Vector, steps);
            const Real measured = measured_limit(sheet.model, sheet.state,
                                                 {.integrator = IntegratorKind::ExplicitEuler}, expected / 2, steps);
            EXPECT_NEAR(measured / expected, 1, 0.15) << "damping " << damping << ", steps " << steps;
            EXPECT_GT(measured, sheet.predicted(IntegratorKind::ExplicitEuler));
        }
    }
}

TEST(TriedStep, FailsByLeavingTheReachOfTheSheet) {
    TrialSheet sheet(8, 1e3, 0);
    sheet.state.v.col(0).setConstant(5);
    EXPECT_EQ(try_step(sheet.model, sheet.state, {.integrator = IntegratorKind::VelocityVerlet}, Real(2e-4)),
              TrialEnd::OutOfReach);
}

/// How 300 steps of a sheet end that falls and swings, hung by two corners.
TrialEnd tried(const IntegratorParameters& method, Real stiffness, Real step, Real damping = 0) {
    ClothParameters parameters;
    parameters.particles = {8, 8};
    parameters.structural = parameters.shear = parameters.bend = {stiffness, damping};
    parameters.drag = 0;
    parameters.pinned.kind = Pins::Kind::Two;
    return try_step(make_cloth_model(parameters), make_rest_state(parameters), method, step, 300);
}

using enum IntegratorKind;

TEST(Unconditional, BackwardEulerAndBdf2AreWithTheClampedHessian) {
    for (const auto kind : {BackwardEuler, Bdf2}) {
        for (const double stiffness : {1e2, 1e4, 1e6}) {
            for (const Real damping : {Real(0), Real(0.1)}) {
                EXPECT_EQ(tried({.integrator = kind}, static_cast<Real>(stiffness), Real(0.05), damping),
                          TrialEnd::Bounded)
                    << name_of(kind) << ", stiffness " << stiffness << ", damping " << damping;
            }
        }
    }
}

// The permanent fault of the test above: the other Hessian in its place
TEST(Unconditional, BackwardEulerAndBdf2AreNotWithTheExactHessian) {
    for (const auto kind : {BackwardEuler, Bdf2}) {
        const IntegratorParameters method{.integrator = kind, .hessian = Hessian::Exact};
        EXPECT_EQ(tried(method, Real(1e5), Real(1) / 30), TrialEnd::EnergyRose) << name_of(kind);
    }
}

TEST(Unconditional, ImplicitMidpointIsNotWithAnyHessian) {
    for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
        const IntegratorParameters method{.integrator = ImplicitMidpoint, .hessian = hessian};
        EXPECT_EQ(tried(method, Real(1e5), Real(0.05)), TrialEnd::EnergyRose);
        EXPECT_EQ(tried(method, Real(1e5), Real(1e-3)), TrialEnd::Bounded);
    }
}

TEST(Unconditional, PositionalMethodsDoNotGrowButLeaveStiffSpringsStretched) {
    const IntegratorParameters one{.integrator = Xpbd, .iterations = 1}, many{.integrator = Xpbd, .iterations = 20};
    const IntegratorParameters projective{.integrator = ProjectiveDynamics};
    const Real frame = Real(1) / 60;
    for (const auto& method : {one, many, projective}) {
        EXPECT_EQ(tried(method, Real(1e6), frame), TrialEnd::Stretched) << name_of(method.integrator);
        EXPECT_EQ(tried(method, Real(1e2), frame), TrialEnd::Bounded) << name_of(method.integrator);
    }
    // Where one iteration is not enough, twenty are
    EXPECT_EQ(tried(one, Real(1e4), frame), TrialEnd::Stretched);
    EXPECT_EQ(tried(many, Real(1e4), frame), TrialEnd::Bounded);
}

}  // namespace
}  // namespace drape
