// Backward Euler, implicit midpoint and BDF2.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "drape/integrate/integrator.h"
#include "drape/model/energy.h"
#include "drape/model/forces.h"
#include "drape/model/jacobian.h"
#include "integrate/damped_sheet.h"
#include "support/allocations.h"

namespace drape {
namespace {

using test::after;
using test::Sheet;

constexpr IntegratorKind implicit_kinds[] = {IntegratorKind::BackwardEuler, IntegratorKind::ImplicitMidpoint,
                                             IntegratorKind::Bdf2};
constexpr Hessian hessians[] = {Hessian::Clamped, Hessian::Exact};

/// Calls test(parameters, message) for every implicit method with both kinds of slopes.
template <class Test>
void with_each(Test test) {
    for (const IntegratorKind kind : implicit_kinds) {
        for (const Hessian hessian : hessians) {
            SCOPED_TRACE(std::string(name_of(kind)) + ", " + name_of(hessian));
            test(IntegratorParameters{.kind = kind, .hessian = hessian});
        }
    }
}

void expect_order(const IntegratorParameters& parameters, Real order) {
    for (const Real observed : test::observed_orders(parameters)) {
        EXPECT_GT(observed, order - 0.15) << name_of(parameters.kind);
        EXPECT_LT(observed, order + 0.25) << name_of(parameters.kind);
    }
}

TEST(ImplicitMethods, ReachTheirOrders) {
    expect_order({.kind = IntegratorKind::BackwardEuler, .hessian = Hessian::Exact}, 1);
    expect_order({.kind = IntegratorKind::BackwardEuler, .hessian = Hessian::Clamped}, 1);
    expect_order({.kind = IntegratorKind::ImplicitMidpoint, .hessian = Hessian::Exact}, 2);
    expect_order({.kind = IntegratorKind::Bdf2, .hessian = Hessian::Exact}, 2);
}

TEST(ImplicitMethods, OfOrderTwoAreOfOrderOneWhenClamped) {
    expect_order({.kind = IntegratorKind::ImplicitMidpoint, .hessian = Hessian::Clamped}, 1);
    expect_order({.kind = IntegratorKind::Bdf2, .hessian = Hessian::Clamped}, 1);
}

/// Two particles on springs along x from two pinned ones, moving alike: a damped oscillator, y' = A y for
/// y = (elongation, velocity).
struct Oscillator {
    ClothModel model;
    ClothState start;
    Eigen::Matrix2d a;

    Oscillator() {
        ClothParameters parameters;
        parameters.particles = {2, 2};
        parameters.structural = {50, 0.3};
        parameters.shear = parameters.bend = {};
        parameters.drag = 0.05;
        parameters.pinned = {Pins::Kind::List, {0, 2}};
        model = make_cloth_model(parameters);
        model.gravity.setZero();
        start = make_rest_state(parameters);
        for (const int p : {1, 3}) start.x(p, 0) += 0.1, start.v(p, 0) = 2;
        a << 0, 1, -50 / model.particle_mass, -(0.3 + 0.05) / model.particle_mass;
    }

    [[nodiscard]] static Eigen::Vector2d of(const ClothState& state) { return {state.x(1, 0) - 1, state.v(1, 0)}; }
};

TEST(ImplicitMethods, MakeTheirStepOfALinearOscillator) {
    const Oscillator oscillator;
    const Real h = 0.04;
    const Eigen::Matrix2d one = Eigen::Matrix2d::Identity(), ha = h * oscillator.a;
    const Eigen::Vector2d y0 = Oscillator::of(oscillator.start);
    for (const Hessian hessian : hessians) {
        const auto stepped = [&](IntegratorKind kind, int steps) {
            return Oscillator::of(
                after({.kind = kind, .hessian = hessian}, oscillator.model, oscillator.start, h * steps, steps));
        };
        const Eigen::Vector2d euler = (one - ha).inverse() * y0;
        EXPECT_LT((stepped(IntegratorKind::BackwardEuler, 1) - euler).norm(), 1e-13);
        const Eigen::Matrix2d middle = (one - ha / 2).inverse() * (one + ha / 2);
        EXPECT_LT((stepped(IntegratorKind::ImplicitMidpoint, 2) - middle * middle * y0).norm(), 1e-13);
        const auto bdf2 = [&](const Eigen::Vector2d& before, const Eigen::Vector2d& now) {
            return Eigen::Vector2d((one - 2 * ha / 3).inverse() * (4 * now - before) / 3);
        };
        const Eigen::Vector2d second = bdf2(y0, euler);
        EXPECT_LT((stepped(IntegratorKind::Bdf2, 1) - euler).norm(), 1e-13);
        EXPECT_LT((stepped(IntegratorKind::Bdf2, 2) - second).norm(), 1e-13);
        EXPECT_LT((stepped(IntegratorKind::Bdf2, 3) - bdf2(euler, second)).norm(), 1e-13);
    }
}

TEST(ImplicitMethods, SolveTheirSystem) {
    // On grids that are factored and on grids that are iterated; gentle steps and large ones
    for (const Grid grid : {Grid{5, 4}, Grid{20, 15}}) {
        const Sheet sheet(grid);
        const ClothState& start = sheet.start;
        const Eigen::Index n = grid.particles();
        for (const Real h : {1e-3, 1.0 / 30, 0.1}) {
            for (const Hessian hessian : hessians) {
                const auto integrator =
                    make_integrator({.kind = IntegratorKind::BackwardEuler, .hessian = hessian}, grid);
                ClothState state = start;
                const SolveReport report = integrator->step(sheet.model, state, h);
                const Points dv = state.v - start.v;

                Jacobian jacobian(grid, hessian, Kernels::Vector);
                jacobian.linearise(sheet.model, start.x, start.v);
                Points right(n, 3);
                compute_forces(sheet.model, start.x, start.v, right);
                jacobian.add_product(-h, 0, start.v, right);
                right *= h;
                Points left = sheet.model.particle_mass * dv;
                jacobian.add_product(h * h, h, dv, left);
                for (int p = 0; p < n; ++p) {
                    if (sheet.model.pinned(p)) left.row(p).setZero(), right.row(p).setZero();
                }
                const Real residual = (left - right).norm() / right.norm();
                EXPECT_LT(residual, 1e-5) << grid.nx << ", " << h;
                EXPECT_EQ(report.unconverged, 0) << grid.nx << ", " << h;
                EXPECT_GT(report.tolerance, 0);
                EXPECT_NEAR(report.residual, residual, 1e-3 * residual + 1e-12) << grid.nx << ", " << h;
                EXPECT_GE(report.iterations, 1);
            }
        }
    }
}

TEST(ImplicitMethods, KeepPinnedParticlesToTheBit) {
    for (const Grid grid : {Grid{5, 4}, Grid{12, 11}}) {
        const Sheet sheet(grid);
        with_each([&](const IntegratorParameters& parameters) {
            const ClothState state = after(parameters, sheet.model, sheet.start, 0.1, 20);
            for (int p = 0; p < grid.particles(); ++p) {
                if (!sheet.model.pinned(p)) continue;
                EXPECT_EQ(state.x.row(p), sheet.start.x.row(p));
                EXPECT_EQ(state.v.row(p), sheet.start.v.row(p));
            }
        });
    }
}

TEST(ImplicitMethods, MoveAHeldParticleAsTheHandDoes) {
    const Sheet sheet;
    const Real h = 0.01;
    with_each([&](const IntegratorParameters& parameters) {
        const auto integrator = make_integrator(parameters, sheet.model.grid);
        ClothState state = sheet.start;
        const Vec3 velocity(0.3, -0.7, 1.1);
        state.v.row(0) = velocity.transpose();
        Vec3 place = state.x.row(0).transpose();
        for (int step = 0; step < 10; ++step) {
            integrator->step(sheet.model, state, h);
            place += h * velocity;
            EXPECT_EQ(Vec3(state.x.row(0).transpose()), place);
            EXPECT_EQ(Vec3(state.v.row(0).transpose()), velocity);
        }
    });
}

TEST(ImplicitMethods, FollowTheHandsThatCarryACloth) {
    // A cloth at rest in the moving frame of its pins stays at rest there: the pins' own velocity is part of K v
    Sheet sheet;
    sheet.undamp();
    sheet.model.gravity.setZero();
    ClothState start = make_rest_state(sheet.parameters);
    const Vec3 velocity(0.3, -0.7, 1.1);
    start.v.rowwise() = velocity.transpose();
    with_each([&](const IntegratorParameters& parameters) {
        const ClothState state = after(parameters, sheet.model, start, 1, 20);
        const Points expected = start.x.rowwise() + velocity.transpose();
        EXPECT_LT((state.x - expected).norm(), 1e-12);
        EXPECT_LT((state.v - start.v).norm(), 1e-12);
    });
}

TEST(ImplicitMethods, GoOnFromTheStateAlone) {
    // An integrator that has stepped elsewhere, with another step, goes on as a new one does
    const Sheet sheet;
    const ClothState elsewhere = after({.kind = IntegratorKind::Rk4}, sheet.model, sheet.start, 0.05, 100);
    with_each([&](const IntegratorParameters& parameters) {
        const auto used = make_integrator(parameters, sheet.model.grid);
        ClothState state = sheet.start;
        for (int step = 0; step < 3; ++step) used->step(sheet.model, state, 0.02);
        state = elsewhere;
        for (int step = 0; step < 3; ++step) used->step(sheet.model, state, 0.01);
        const ClothState fresh = after(parameters, sheet.model, elsewhere, 0.03, 3);
        EXPECT_EQ(state.x, fresh.x);
        EXPECT_EQ(state.v, fresh.v);
    });
}

TEST(Bdf2, StartsAnewByBackwardEulerWhenSomethingWasTouched) {
    const Sheet sheet;
    const auto begins_anew = [&](auto touch) {
        const auto bdf2 = make_integrator({.kind = IntegratorKind::Bdf2}, sheet.model.grid);
        ClothModel model = sheet.model;
        ClothState state = sheet.start;
        Real h = 0.01;
        for (int step = 0; step < 3; ++step) bdf2->step(model, state, h);
        touch(model, state, h);
        ClothState euler = state;
        bdf2->step(model, state, h);
        make_integrator({.kind = IntegratorKind::BackwardEuler}, model.grid)->step(model, euler, h);
        return (state.v - euler.v).norm() < 1e-13 && (state.x - euler.x).norm() < 1e-14;
    };
    EXPECT_FALSE(begins_anew([](ClothModel&, ClothState&, Real&) {}));
    EXPECT_TRUE(begins_anew([](ClothModel&, ClothState& s, Real&) { s.x(7, 1) += 1e-15; }));
    EXPECT_TRUE(begins_anew([](ClothModel&, ClothState& s, Real&) { s.v(7, 1) *= 0.5; }));
    EXPECT_TRUE(begins_anew([](ClothModel&, ClothState&, Real& h) { h /= 2; }));
    EXPECT_TRUE(begins_anew([](ClothModel& m, ClothState&, Real&) { m.hold(9, true); }));
}

/// The part of a small oscillation's energy that is left after a hundred periods of its quickest mode and more.
Real energy_kept(IntegratorKind kind) {
    Sheet sheet;
    sheet.undamp();
    sheet.model.gravity.setZero();
    ClothState state = make_rest_state(sheet.parameters);
    state.v = 1e-4 * sheet.start.v;
    state.v.col(1).setZero();  // in the plane, where the springs are linear
    const Real before = compute_energy(sheet.model, state, Kernels::Vector).total();
    state = after({.kind = kind, .hessian = Hessian::Exact}, sheet.model, state, 10, 1000);
    return compute_energy(sheet.model, state, Kernels::Vector).total() / before;
}

TEST(ImplicitMidpoint, KeepsTheEnergyOfASmallOscillation) {
    EXPECT_NEAR(energy_kept(IntegratorKind::ImplicitMidpoint), 1, 1e-3);
    EXPECT_LT(energy_kept(IntegratorKind::BackwardEuler), 0.5);
    EXPECT_LT(energy_kept(IntegratorKind::Bdf2), 0.99);
}

TEST(ClampedMethods, StayFiniteAtAnyStepAndStiffness) {
    for (const Real damping : {0.0, 0.02}) {
        ClothParameters parameters;
        parameters.particles = {10, 10};
        parameters.structural = parameters.shear = parameters.bend = {1e6, damping};
        parameters.pinned.kind = Pins::Kind::Two;
        const ClothModel model = make_cloth_model(parameters);
        for (const IntegratorKind kind : implicit_kinds) {
            const ClothState state = after({.kind = kind}, model, make_rest_state(parameters), 10, 200);
            EXPECT_TRUE(state.x.allFinite() && state.v.allFinite()) << name_of(kind) << ", damping " << damping;
            if (kind == IntegratorKind::ImplicitMidpoint) continue;  // it does not damp: see the tables of stability
            EXPECT_LT(state.x.cwiseAbs().maxCoeff(), 2.5) << name_of(kind) << ", damping " << damping;
        }
    }
}

TEST(ImplicitMethods, AllocateNothingAfterTheFirstStep) {
    for (const Grid grid : {Grid{5, 4}, Grid{20, 15}}) {
        const Sheet sheet(grid);
        with_each([&](const IntegratorParameters& parameters) {
            const auto integrator = make_integrator(parameters, grid);
            ClothState state = sheet.start;
            integrator->step(sheet.model, state, 1e-3);
            const auto before = test::allocations();
            for (const Real h : {1e-3, 1e-3, 0.05, 0.05}) integrator->step(sheet.model, state, h);
            EXPECT_EQ(test::allocations(), before);
        });
    }
}

TEST(ImplicitMethods, AreFiniteWhereSpringsHaveNoLength) {
    const Sheet sheet;
    ClothState start = sheet.start;
    start.x.row(7) = start.x.row(8);
    start.v.row(7) = start.v.row(8);
    with_each([&](const IntegratorParameters& parameters) {
        const ClothState state = after(parameters, sheet.model, start, 0.01, 1);
        EXPECT_TRUE(state.x.allFinite() && state.v.allFinite());
    });
}

}  // namespace
}  // namespace drape
