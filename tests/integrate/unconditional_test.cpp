#include <gtest/gtest.h>

#include "drape/integrate/stability_trial.h"

namespace drape {
namespace {

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
                EXPECT_EQ(tried({.kind = kind}, static_cast<Real>(stiffness), Real(0.05), damping), TrialEnd::Bounded)
                    << name_of(kind) << ", stiffness " << stiffness << ", damping " << damping;
            }
        }
    }
}

// The permanent fault of the test above: the other Hessian in its place
TEST(Unconditional, BackwardEulerAndBdf2AreNotWithTheExactHessian) {
    for (const auto kind : {BackwardEuler, Bdf2}) {
        const IntegratorParameters method{.kind = kind, .hessian = Hessian::Exact};
        EXPECT_EQ(tried(method, Real(1e5), Real(1) / 30), TrialEnd::EnergyRose) << name_of(kind);
    }
}

TEST(Unconditional, ImplicitMidpointIsNotWithAnyHessian) {
    for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
        const IntegratorParameters method{.kind = ImplicitMidpoint, .hessian = hessian};
        EXPECT_EQ(tried(method, Real(1e5), Real(0.05)), TrialEnd::EnergyRose);
        EXPECT_EQ(tried(method, Real(1e5), Real(1e-3)), TrialEnd::Bounded);
    }
}

TEST(Unconditional, PositionalMethodsDoNotGrowButLeaveStiffSpringsStretched) {
    const IntegratorParameters one{.kind = Xpbd, .iterations = 1}, many{.kind = Xpbd, .iterations = 20};
    const IntegratorParameters projective{.kind = ProjectiveDynamics};
    const Real frame = Real(1) / 60;
    for (const auto& method : {one, many, projective}) {
        EXPECT_EQ(tried(method, Real(1e6), frame), TrialEnd::Stretched) << name_of(method.kind);
        EXPECT_EQ(tried(method, Real(1e2), frame), TrialEnd::Bounded) << name_of(method.kind);
    }
    // Where one iteration is not enough, twenty are
    EXPECT_EQ(tried(one, Real(1e4), frame), TrialEnd::Stretched);
    EXPECT_EQ(tried(many, Real(1e4), frame), TrialEnd::Bounded);
}

}  // namespace
}  // namespace drape
