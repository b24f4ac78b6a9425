#include "drape/integrate/stability.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drape {
namespace {

struct RestSheet {
    ClothModel model;
    ClothState state;
};

RestSheet rest_sheet(int side, SpringLaw structural, SpringLaw shear, SpringLaw bend) {
    ClothParameters parameters;
    parameters.particles = {side, side};
    parameters.structural = structural;
    parameters.shear = shear;
    parameters.bend = bend;
    parameters.drag = 0;
    return {make_cloth_model(parameters), make_rest_state(parameters)};
}

/// lambda = m omega^2 of the undamped flat sheet, in units of k.
Real lambda_at_rest(int side, Real shear, Real bend) {
    constexpr Real k = 300;
    const RestSheet sheet = rest_sheet(side, {k, 0}, {shear * k, 0}, {bend * k, 0});
    const Real omega =
        predicted_limit(sheet.model, sheet.state, IntegratorKind::SymplecticEuler, Kernels::Vector).omega;
    return omega * omega * sheet.model.particle_mass / k;
}

TEST(HighestFrequency, OfALargeFlatSheetIsThatOfTheInfiniteLattice) {
    // Structural springs alone: neighbours swing against each other. All three kinds alike: the wave that runs along
    // the diagonal with cos(phase) = -1/8 a column and row, for which lambda = k (2 (1 - c) + 8 (1 - c^2)).
    EXPECT_NEAR(lambda_at_rest(64, 0, 0), 4, 0.002 * 4);
    EXPECT_NEAR(lambda_at_rest(64, 1, 1), 10.125, 0.002 * 10.125);
    EXPECT_NEAR(lambda_at_rest(150, 1, 1), 10.125, 0.004 * 10.125) << "searched in windows";
}

TEST(HighestFrequency, OfALargeClothIsSoughtWhereItsSpringsPull) {
    RestSheet sheet = rest_sheet(200, {300, 0}, {300, 0}, {300, 0});
    const Real at_rest = predicted_limit(sheet.model, sheet.state, IntegratorKind::Rk4, Kernels::Vector).omega;
    // The last columns are drawn out, a window's width from the middle
    for (int j = 0; j < 200; ++j) {
        for (int i = 180; i < 200; ++i) {
            sheet.state.x(sheet.model.grid.particle(i, j), 0) += Real(i - 180) * sheet.model.hx * Real(0.5);
        }
    }
    EXPECT_GT(predicted_limit(sheet.model, sheet.state, IntegratorKind::Rk4, Kernels::Vector).omega,
              Real(1.01) * at_rest);
}

TEST(PredictedLimit, IsInfiniteWithoutSpringsOrWhatMovesAndForImplicitMethods) {
    const RestSheet loose = rest_sheet(10, {}, {}, {}), sheet = rest_sheet(10, {500, 0}, {200, 0}, {50, 0});
    for (const IntegratorKind kind : {IntegratorKind::ExplicitEuler, IntegratorKind::SymplecticEuler,
                                      IntegratorKind::VelocityVerlet, IntegratorKind::Rk4}) {
        EXPECT_TRUE(std::isinf(predicted_limit(loose.model, loose.state, kind, Kernels::Vector).step)) << name_of(kind);
    }
    RestSheet pinned = rest_sheet(4, {500, 1}, {200, 1}, {50, 1});
    pinned.model.inverse_mass.setZero();
    EXPECT_TRUE(std::isinf(predicted_limit(pinned.model, pinned.state, IntegratorKind::Rk4, Kernels::Vector).step));
    const StepLimit limit = predicted_limit(sheet.model, sheet.state, IntegratorKind::BackwardEuler, Kernels::Vector);
    EXPECT_TRUE(std::isinf(limit.step));
    EXPECT_EQ(predicted_limit(sheet.model, sheet.state, IntegratorKind::ExplicitEuler, Kernels::Vector).step, 0)
        << "none without damping";
}

TEST(LongestStep, UndampedIsTheClosedForm) {
    EXPECT_EQ(longest_step(IntegratorKind::ExplicitEuler, 25, 0), 0);
    EXPECT_NEAR(longest_step(IntegratorKind::SymplecticEuler, 25, 0) * 5, 2, 1e-9);
    EXPECT_NEAR(longest_step(IntegratorKind::VelocityVerlet, 25, 0) * 5, 2, 1e-5);
    EXPECT_NEAR(longest_step(IntegratorKind::Rk4, 25, 0) * 5, 2 * std::sqrt(2), 1e-5);
}

TEST(LongestStep, OfPureDampingIsWhereADecayTurnsIntoGrowth) {
    EXPECT_NEAR(longest_step(IntegratorKind::ExplicitEuler, 0, 3), 2.0 / 3, 1e-9);
    EXPECT_NEAR(longest_step(IntegratorKind::SymplecticEuler, 0, 3), 2.0 / 3, 1e-9);
    EXPECT_NEAR(longest_step(IntegratorKind::VelocityVerlet, 0, 3), 2.0 / 3, 1e-5);
    EXPECT_NEAR(longest_step(IntegratorKind::Rk4, 0, 3) * 3, 2.785293563, 1e-5) << "the real end of its region";
}

}  // namespace
}  // namespace drape
