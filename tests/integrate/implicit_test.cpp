// Backward Euler, implicit midpoint and BDF2.

#include <gtest/gtest.h>

#include <cmath>

#include "drape/integrate/integrator.h"
#include "drape/model/forces.h"
#include "drape/model/jacobian.h"
#include "integrate/damped_sheet.h"

namespace drape {
namespace {

using test::after;
using test::Sheet;

TEST(ImplicitMethods, SolveTheirSystem) {
    // On grids that are factored and on grids that are iterated; gentle steps and large ones
    for (const Grid grid : {Grid{5, 4}, Grid{20, 15}}) {
        const Sheet sheet(grid);
        const ClothState& start = sheet.start;
        const Eigen::Index n = grid.particles();
        for (const Real h : {1e-3, 1.0 / 30, 0.1}) {
            for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
                const auto integrator = make_integrator(
                    {.integrator = IntegratorKind::BackwardEuler, .hessian = hessian, .tolerance = Real(1e-6)}, grid);
                ClothState state = start;
                const SolveReport report = integrator->step(sheet.model, state, h);
                const Points dv = state.v - start.v;

                // Gentle steps begin where they lead, large ones where they are
                const bool ahead = h < 0.01;
                Points x = start.x, right(n, 3);
                if (ahead) x += h * start.v;
                Jacobian jacobian(grid, hessian, Kernels::Vector);
                jacobian.linearise(sheet.model, x, start.v);
                compute_forces(sheet.model, x, start.v, right);
                if (!ahead) jacobian.add_product(-h, 0, start.v, right);
                right *= h;
                Points left = sheet.model.particle_mass * dv;
                jacobian.add_product(h * h, h, dv, left);
                for (int p = 0; p < n; ++p) {
                    if (sheet.model.pinned(p)) left.row(p).setZero(), right.row(p).setZero();
                }
                const Real residual = (left - right).norm() / right.norm();
                EXPECT_LT(residual, 1e-5) << grid.nx << ", " << h;
                EXPECT_EQ(report.unconverged, 0) << grid.nx << ", " << h;
                EXPECT_EQ(report.tolerance, Real(1e-6));
                EXPECT_NEAR(report.residual, residual, 1e-3 * residual + 1e-12) << grid.nx << ", " << h;
                EXPECT_GE(report.iterations, 1);
            }
        }
    }
}

TEST(ImplicitMethods, AreTheSameInAMovingFrame) {
    ClothParameters parameters;
    parameters.particles = {10, 10};
    parameters.structural.stiffness = 10'000;
    parameters.drag = 0;
    ClothModel model = make_cloth_model(parameters);
    model.gravity.setZero();
    for (const auto kind : {IntegratorKind::BackwardEuler, IntegratorKind::Bdf2}) {
        const auto shape_after = [&](Real speed) {
            ClothState state = make_rest_state(parameters);
            for (Eigen::Index p = 0; p < state.v.rows(); ++p) state.v(p, 1) = std::sin(static_cast<Real>(p));
            state.v.col(0).array() += speed;
            const auto integrator = make_integrator({.integrator = kind, .tolerance = Real(1e-10)}, model.grid);
            for (int step = 0; step < 60; ++step) integrator->step(model, state, Real(1) / 60);
            return Points(state.x.rowwise() - state.x.colwise().mean());
        };
        EXPECT_LT((shape_after(100) - shape_after(0)).cwiseAbs().maxCoeff(), 1e-3) << name_of(kind);
    }
}

TEST(ImplicitMethods, FollowTheHandsThatCarryACloth) {
    // A cloth at rest in the moving frame of its pins stays at rest there: the pins' own velocity is part of K v
    Sheet sheet;
    sheet.undamp();
    sheet.model.gravity.setZero();
    ClothState start = make_rest_state(sheet.parameters);
    const Vec3 velocity(0.3, -0.7, 1.1);
    start.v.rowwise() = velocity.transpose();
    for (const IntegratorParameters& method : test::implicit_methods()) {
        const ClothState state = after(method, sheet.model, start, 1, 20);
        const Points expected = start.x.rowwise() + velocity.transpose();
        EXPECT_LT((state.x - expected).norm(), 1e-12) << test::text_of(method);
        EXPECT_LT((state.v - start.v).norm(), 1e-12) << test::text_of(method);
    }
}

TEST(Bdf2, StartsAnewByBackwardEulerWhenSomethingWasTouched) {
    const Sheet sheet;
    const auto begins_anew = [&](auto touch) {
        const auto bdf2 = make_integrator({.integrator = IntegratorKind::Bdf2}, sheet.model.grid);
        ClothModel model = sheet.model;
        ClothState state = sheet.start;
        Real h = 0.01;
        for (int step = 0; step < 3; ++step) bdf2->step(model, state, h);
        touch(model, state, h);
        ClothState euler = state;
        bdf2->step(model, state, h);
        make_integrator({.integrator = IntegratorKind::BackwardEuler}, model.grid)->step(model, euler, h);
        return (state.v - euler.v).norm() < 1e-13 && (state.x - euler.x).norm() < 1e-14;
    };
    EXPECT_FALSE(begins_anew([](ClothModel&, ClothState&, Real&) {}));
    EXPECT_TRUE(begins_anew([](ClothModel&, ClothState& s, Real&) { s.x(7, 1) += 1e-15; }));
    EXPECT_TRUE(begins_anew([](ClothModel&, ClothState& s, Real&) { s.v(7, 1) *= 0.5; }));
    EXPECT_TRUE(begins_anew([](ClothModel&, ClothState&, Real& h) { h /= 2; }));
    EXPECT_TRUE(begins_anew([](ClothModel& m, ClothState&, Real&) { m.hold(9, true); }));
}

constexpr Real picture = Real(1) / 60;  // s

ClothParameters hung_sheet() {
    ClothParameters sheet;
    sheet.particles = {12, 12};
    sheet.mass = Real(0.2);
    sheet.pinned.kind = Pins::Kind::Two;
    return sheet;
}

/// Where a sheet is that has fallen from two corners, at the end of each of some steps.
std::vector<ClothState> swing(IntegratorKind kind, int newton_steps, int steps, int parts = 1) {
    const ClothParameters parameters = hung_sheet();
    const ClothModel model = make_cloth_model(parameters);
    const auto integrator = make_integrator({.integrator = kind, .newton_steps = newton_steps}, model.grid);
    std::vector<ClothState> states{make_rest_state(parameters)};
    for (int k = 0; k < steps; ++k) {
        states.push_back(states.back());
        for (int part = 0; part < parts; ++part)
            integrator->step(model, states.back(), picture / static_cast<Real>(parts));
    }
    return states;
}

/// What a last step leaves of the equations of its method, of m g h.
Real left_of(IntegratorKind kind, int newton_steps) {
    const ClothParameters parameters = hung_sheet();
    const ClothModel model = make_cloth_model(parameters);
    const std::vector<ClothState> states = swing(kind, newton_steps, 12);
    const ClothState &earlier = states[10], &from = states[11], &to = states[12];
    Points x = to.x, v = to.v, f(x.rows(), 3), change = to.v - from.v;
    Real s = picture;
    if (kind == IntegratorKind::ImplicitMidpoint) {
        x = (from.x + to.x) / 2;
        v = (from.v + to.v) / 2;
    }
    if (kind == IntegratorKind::Bdf2) {
        s = 2 * picture / 3;
        change -= (from.v - earlier.v) / 3;
    }
    compute_forces(model, x, v, f);
    Points left = model.particle_mass * change - s * f;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) left.row(p).setZero();
    }
    return left.norm() / (model.particle_mass * model.gravity.norm() * picture);
}

class NewtonSteps : public testing::TestWithParam<IntegratorKind> {};

TEST_P(NewtonSteps, ComeNearerToTheNonlinearEquations) {
    const Real one = left_of(GetParam(), 1), two = left_of(GetParam(), 2), six = left_of(GetParam(), 6);
    EXPECT_LT(two, one / 2);
    EXPECT_LT(six, one / 10);
}

TEST_P(NewtonSteps, MakeALongStepMoreAccurate) {
    const Points exact = swing(IntegratorKind::Rk4, 1, 15, 200).back().x;
    const Real one = (swing(GetParam(), 1, 15).back().x - exact).norm();
    const Real two = (swing(GetParam(), 2, 15).back().x - exact).norm();
    EXPECT_LT(two, one);
}

INSTANTIATE_TEST_SUITE_P(Of, NewtonSteps,
                         testing::Values(IntegratorKind::BackwardEuler, IntegratorKind::ImplicitMidpoint,
                                         IntegratorKind::Bdf2),
                         [](const auto& of) { return name_of(of.param); });

}  // namespace
}  // namespace drape
