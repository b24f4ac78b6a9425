// What every method must do.

#include "drape/integrate/integrator.h"

#include <gtest/gtest.h>

#include "integrate/damped_sheet.h"
#include "support/allocations.h"

namespace drape {
namespace {

using test::after;
using test::all_methods;
using test::Sheet;
using test::text_of;
using Kind = IntegratorKind;

TEST(Integrators, ReachTheirOrders) {
    const struct {
        IntegratorParameters method;
        Real order;
    } cases[] = {{{.integrator = Kind::ExplicitEuler}, 1},
                 {{.integrator = Kind::SymplecticEuler}, 1},
                 {{.integrator = Kind::VelocityVerlet}, 2},
                 {{.integrator = Kind::Rk4}, 4},
                 {{.integrator = Kind::BackwardEuler, .hessian = Hessian::Exact}, 1},
                 {{.integrator = Kind::ImplicitMidpoint, .hessian = Hessian::Exact}, 2},
                 {{.integrator = Kind::Bdf2, .hessian = Hessian::Exact}, 2},
                 // What the clamped Hessian leaves out costs no order, as a step begins where it leads
                 {{.integrator = Kind::BackwardEuler, .hessian = Hessian::Clamped}, 1},
                 {{.integrator = Kind::ImplicitMidpoint, .hessian = Hessian::Clamped}, 2},
                 {{.integrator = Kind::Bdf2, .hessian = Hessian::Clamped}, 2},
                 {{.integrator = Kind::Xpbd, .iterations = 1}, 1},
                 {{.integrator = Kind::Xpbd, .iterations = 20}, 1},
                 {{.integrator = Kind::ProjectiveDynamics}, 1}};
    for (const auto& one : cases) {
        for (const Real observed : test::observed_orders(one.method)) {
            EXPECT_GT(observed, one.order - 0.15) << text_of(one.method);
            EXPECT_LT(observed, one.order + 0.25) << text_of(one.method);
        }
    }
}

TEST(Integrators, KeepPinnedParticlesToTheBit) {
    // A grid whose implicit systems are factored and one whose are iterated
    for (const Grid grid : {Grid{5, 4}, Grid{12, 11}}) {
        const Sheet sheet(grid);
        for (const IntegratorParameters& method : all_methods()) {
            const ClothState state = after(method, sheet.model, sheet.start, 0.05, 50);
            for (int p = 0; p < grid.particles(); ++p) {
                if (!sheet.model.pinned(p)) continue;
                EXPECT_EQ(state.x.row(p), sheet.start.x.row(p)) << text_of(method);
                EXPECT_EQ(state.v.row(p), sheet.start.v.row(p)) << text_of(method);
            }
        }
    }
}

TEST(Integrators, ThatSolveForTheNewStateMoveAHeldParticleAsTheHandDoes) {
    const Sheet sheet;
    const Real h = 0.01;
    std::vector<IntegratorParameters> methods = test::implicit_methods();
    methods.push_back({.integrator = Kind::Xpbd});
    methods.push_back({.integrator = Kind::ProjectiveDynamics});
    for (const IntegratorParameters& method : methods) {
        const auto integrator = make_integrator(method, sheet.model.grid);
        ClothState state = sheet.start;
        const Vec3 velocity(0.3, -0.7, 1.1);
        state.v.row(0) = velocity.transpose();
        Vec3 place = state.x.row(0).transpose();
        for (int step = 0; step < 10; ++step) {
            integrator->step(sheet.model, state, h);
            place += h * velocity;
            EXPECT_EQ(Vec3(state.x.row(0).transpose()), place) << text_of(method);
            EXPECT_EQ(Vec3(state.v.row(0).transpose()), velocity) << text_of(method);
        }
    }
}

TEST(Integrators, ConserveMomentumWithoutGravity) {
    Sheet sheet;
    sheet.parameters.pinned.kind = Pins::Kind::None;
    sheet.parameters.drag = 0;
    sheet.model = make_cloth_model(sheet.parameters);
    sheet.model.gravity.setZero();
    const auto momentum = [](const ClothState& s) { return s.v.colwise().sum().eval(); };
    for (const Kind kind : {Kind::ExplicitEuler, Kind::SymplecticEuler, Kind::VelocityVerlet, Kind::Rk4, Kind::Xpbd,
                            Kind::ProjectiveDynamics}) {
        const ClothState state = after({.integrator = kind}, sheet.model, sheet.start, 0.2, 400);
        const Real scale = sheet.start.v.cwiseAbs().sum();
        EXPECT_LT((momentum(state) - momentum(sheet.start)).norm(), 1e-11 * scale) << name_of(kind);
    }
}

TEST(Integrators, GoOnFromTheStateAlone) {
    // An integrator that has stepped elsewhere, with another step, goes on as a new one does
    const Sheet sheet;
    const ClothState elsewhere = after({.integrator = Kind::Rk4}, sheet.model, sheet.start, 0.05, 100);
    for (const IntegratorParameters& method : all_methods()) {
        const auto used = make_integrator(method, sheet.model.grid);
        ClothState state = sheet.start;
        for (int step = 0; step < 3; ++step) used->step(sheet.model, state, 0.02);
        state = elsewhere;
        for (int step = 0; step < 3; ++step) used->step(sheet.model, state, 0.01);
        const ClothState fresh = after(method, sheet.model, elsewhere, 0.03, 3);
        EXPECT_EQ(state.x, fresh.x) << text_of(method);
        EXPECT_EQ(state.v, fresh.v) << text_of(method);
    }
}

TEST(Integrators, AreFiniteWhereSpringsHaveNoLength) {
    // Two particles in one place, and a cloth that is one point
    const Sheet sheet;
    ClothState touching = sheet.start, point = sheet.start;
    touching.x.row(7) = touching.x.row(8);
    touching.v.row(7) = touching.v.row(8);
    point.x.setZero();
    point.v.setZero();
    for (const IntegratorParameters& method : all_methods()) {
        for (const ClothState& start : {touching, point}) {
            const ClothState state = after(method, sheet.model, start, 0.01, 1);
            EXPECT_TRUE(state.x.allFinite() && state.v.allFinite()) << text_of(method);
        }
    }
}

TEST(Integrators, AllocateNothingAfterTheFirstStep) {
    for (const Grid grid : {Grid{5, 4}, Grid{20, 15}, Grid{24, 20}}) {
        const Sheet sheet(grid);
        for (const IntegratorParameters& method : all_methods()) {
            const auto integrator = make_integrator(method, grid);
            ClothState state = sheet.start;
            integrator->step(sheet.model, state, 1e-3);
            const auto before = test::allocations();
            // Another step is another matrix, for which projective dynamics alone makes room
            const Real other = method.integrator == Kind::ProjectiveDynamics ? 1e-3 : 0.05;
            for (const Real h : {Real(1e-3), other, other}) integrator->step(sheet.model, state, h);
            EXPECT_EQ(test::allocations(), before) << text_of(method);
        }
    }
}

}  // namespace
}  // namespace drape
