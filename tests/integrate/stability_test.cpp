#include "drape/integrate/stability.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>

#include "drape/model/jacobian.h"
#include "support/cloths.h"

namespace drape {
namespace {

constexpr IntegratorKind limited_kinds[] = {IntegratorKind::ExplicitEuler, IntegratorKind::SymplecticEuler,
                                            IntegratorKind::VelocityVerlet, IntegratorKind::Rk4};

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

/// A K + b D of the free particles by mass, as a matrix.
Eigen::MatrixXd dense(const RestSheet& sheet, Real a, Real b) {
    const int n = sheet.model.grid.particles();
    Jacobian slopes(sheet.model.grid, Hessian::Clamped, Kernels::Vector);
    slopes.linearise(sheet.model, sheet.state.x, sheet.state.v);
    Eigen::MatrixXd matrix(3 * n, 3 * n);
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
        Points unit = Points::Zero(n, 3), product = Points::Zero(n, 3);
        unit.data()[column] = 1;
        slopes.add_product(a, b, unit, product);
        matrix.col(column) = product.reshaped() / sheet.model.particle_mass;
    }
    for (int p = 0; p < n; ++p) {
        if (!sheet.model.pinned(p)) continue;
        for (int axis = 0; axis < 3; ++axis) {
            matrix.row(axis * n + p).setZero();
            matrix.col(axis * n + p).setZero();
        }
    }
    return matrix;
}

/// The largest eigenvalue.
double top(const Eigen::MatrixXd& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues().tail(1)[0];
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

TEST(HighestFrequency, OfAFreeChainIsTheClosedForm) {
    // Rows without shear are chains: lambda = 4 k sin^2(pi (n - 1) / 2n), here of 40 particles
    const Real half_turn = std::sin(std::acos(Real(-1)) * 39 / 80);
    EXPECT_NEAR(lambda_at_rest(40, 0, 0), 4 * half_turn * half_turn, 4e-3);
}

TEST(HighestFrequency, IsThatOfTheWholeMatrixInAnyShape) {
    ClothParameters parameters;
    parameters.particles = {9, 8};
    parameters.structural = {500, 0};
    parameters.shear = {900, 0};
    parameters.bend = {50, 0};
    parameters.drag = 0;
    parameters.pinned.list = {0, 5, 40};
    parameters.pinned.kind = Pins::Kind::List;
    std::mt19937 random(7);
    for (int shape = 0; shape < 5; ++shape) {
        const RestSheet sheet{make_cloth_model(parameters), test::random_state(parameters, random)};
        const Real omega = predicted_limit(sheet.model, sheet.state, IntegratorKind::Rk4, Kernels::Vector).omega;
        EXPECT_NEAR(omega * omega / top(dense(sheet, 1, 0)), 1, 1e-3) << shape;
    }
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

TEST(PredictedLimit, OfSymplecticEulerIsExactForAnyDamping) {
    // A sheet whose kinds of springs are damped quite differently. Stable up to the h where h^2 K + 2 h D reaches 4 M.
    const RestSheet sheet = rest_sheet(8, {500, Real(0.001)}, {200, Real(0.3)}, {50, Real(0.1)});
    const StepLimit limit = predicted_limit(sheet.model, sheet.state, IntegratorKind::SymplecticEuler, Kernels::Vector);
    EXPECT_NEAR(top(dense(sheet, limit.step * limit.step, 2 * limit.step)), 4, 4e-3);
    EXPECT_NEAR(limit.step * limit.omega, 2 * (std::sqrt(1 + limit.zeta * limit.zeta) - limit.zeta), 1e-9);
}

TEST(PredictedLimit, OfExplicitEulerIsThatOfItsLeastDampedVibration) {
    const RestSheet sheet = rest_sheet(8, {500, Real(0.001)}, {200, Real(0.003)}, {50, Real(0.001)});
    const Real step = predicted_limit(sheet.model, sheet.state, IntegratorKind::ExplicitEuler, Kernels::Vector).step;
    // Stable while h K <= D; the springs' own ratios of c to k bound it
    EXPECT_LT(top(dense(sheet, Real(0.99) * step, -1)), 0.02 * step * top(dense(sheet, 1, 0)));
    EXPECT_GT(top(dense(sheet, Real(1.01) * step, -1)), 0);
    EXPECT_GE(step, Real(0.999) * Real(2e-6));
    EXPECT_LE(step, Real(5e-6));
}

TEST(PredictedLimit, OfExplicitEulerIsNoneWithoutDamping) {
    const RestSheet sheet = rest_sheet(10, {500, 0}, {200, 0}, {50, 0});
    EXPECT_EQ(predicted_limit(sheet.model, sheet.state, IntegratorKind::ExplicitEuler, Kernels::Vector).step, 0);
}

TEST(PredictedLimit, IsInfiniteWithoutSpringsAndForImplicitMethods) {
    const RestSheet loose = rest_sheet(10, {}, {}, {}), sheet = rest_sheet(10, {500, 0}, {200, 0}, {50, 0});
    for (const IntegratorKind kind : limited_kinds) {
        EXPECT_TRUE(std::isinf(predicted_limit(loose.model, loose.state, kind, Kernels::Vector).step)) << name_of(kind);
    }
    const StepLimit limit = predicted_limit(sheet.model, sheet.state, IntegratorKind::BackwardEuler, Kernels::Vector);
    EXPECT_TRUE(std::isinf(limit.step));
    EXPECT_EQ(limit.formula, "no linear limit");
}

TEST(PredictedLimit, IsInfiniteIfNothingCanMove) {
    RestSheet sheet = rest_sheet(4, {500, 1}, {200, 1}, {50, 1});
    sheet.model.inverse_mass.setZero();
    EXPECT_TRUE(std::isinf(predicted_limit(sheet.model, sheet.state, IntegratorKind::Rk4, Kernels::Vector).step));
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

/// How much a damped oscillator has grown after many steps of the real integrator: two particles on a spring.
Real growth_of_pair(IntegratorKind kind, Real zeta, Real step_by_limit) {
    ClothParameters parameters;
    parameters.particles = {2, 2};
    parameters.structural = {100, 0};
    parameters.shear = parameters.bend = {};
    parameters.drag = 0;
    // A spring between two equal masses: k and d are twice the spring's by mass
    const Real mass = make_cloth_model(parameters).particle_mass, k = 2 * 100 / mass, d = 2 * zeta * std::sqrt(k);
    parameters.structural.damping = d * mass / 2;
    ClothModel model = make_cloth_model(parameters);
    model.gravity.setZero();
    ClothState state = make_rest_state(parameters);
    const Real start = Real(1e-9);
    state.x(0, 0) -= start;
    state.x(1, 0) += start;
    const auto integrator = make_integrator({.kind = kind}, model.grid);
    const Real step = step_by_limit * longest_step(kind, k, d);
    const auto stretch = [&] {
        return std::abs(state.x(1, 0) - state.x(0, 0) - model.hx) + std::abs(state.v(1, 0)) * step;
    };
    const Real before = stretch();
    for (int n = 0; n < 20000; ++n) {
        integrator->step(model, state, step);
        if (stretch() > 1e4 * before) break;
    }
    return stretch() / before;
}

TEST(LongestStep, IsWhereTheMethodsOwnStepsStartToGrow) {
    for (const IntegratorKind kind : limited_kinds) {
        for (const Real zeta : {0.0, 0.01, 0.1, 0.5, 1.0, 1.5, 4.0}) {
            // Its growth is of the size zeta^2 a step, too slow to be seen
            if (kind == IntegratorKind::ExplicitEuler && zeta < Real(0.1)) continue;
            EXPECT_LT(growth_of_pair(kind, zeta, Real(0.98)), 100) << name_of(kind) << " " << zeta;
            EXPECT_GT(growth_of_pair(kind, zeta, Real(1.02)), 100) << name_of(kind) << " " << zeta;
        }
    }
}

}  // namespace
}  // namespace drape
