// Cases of which the solution can be written down, for every method.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "drape/integrate/integrator.h"
#include "integrate/damped_sheet.h"
#include "integrate/true_limit.h"

namespace drape {
namespace {

using test::after;
using Kind = IntegratorKind;

/// The method, as accurate as it can be.
IntegratorParameters accurate(Kind kind) {
    return {.integrator = kind, .hessian = Hessian::Exact, .iterations = 50, .tolerance = Real(1e-11)};
}

/// A cloth of structural springs alone, whose particles weigh `mass` each.
ClothParameters net(const Grid& grid, Real mass, const SpringLaw& structural) {
    ClothParameters parameters;
    parameters.particles = grid;
    parameters.mass = mass * static_cast<Real>(grid.particles());
    parameters.structural = structural;
    parameters.shear = parameters.bend = {};
    parameters.drag = 0;
    return parameters;
}

/// States of y' = A y one step apart, as the methods make them.
using Pair = Eigen::Matrix<Real, 2, 1>;
using Map = Eigen::Matrix<Real, 2, 2>;

/// One step of a method from y, having come from `last`; without one it is the first.
Pair linear_step(Kind kind, const Map& rate, Real h, const Pair& y, const Pair* last) {
    const Map same = Map::Identity(), z = h * rate;
    Map drift = Map::Zero(), kick = Map::Zero();
    drift.row(0) = z.row(0);
    kick.row(1) = z.row(1);
    switch (kind) {
        case Kind::ExplicitEuler:
        case Kind::SymplecticEuler:
        case Kind::VelocityVerlet:
        case Kind::Rk4:
            return test::explicit_step(kind, drift, kick) * y;
        case Kind::ImplicitMidpoint:
            return (same - z / 2).inverse() * (same + z / 2) * y;
        case Kind::Bdf2:
            if (last != nullptr) return (3 * same - 2 * z).inverse() * (4 * y - *last);
            [[fallthrough]];
        case Kind::BackwardEuler:
        case Kind::Xpbd:
            return (same - z).inverse() * y;
        case Kind::ProjectiveDynamics: {
            // Damping first, then stiffness, each implicitly
            Map damping = Map::Zero(), stiffness = z;
            damping(1, 1) = z(1, 1);
            stiffness(1, 1) = 0;
            return (same - stiffness).inverse() * (same - damping).inverse() * y;
        }
        case Kind::DormandPrince:
            break;
    }
    return z.exp() * y;
}

Pair linear_solution(Kind kind, const Map& rate, Real h, Pair y, int steps) {
    Pair last = y;
    for (int step = 0; step < steps; ++step) {
        const Pair next = linear_step(kind, rate, h, y, step > 0 ? &last : nullptr);
        last = y;
        y = next;
    }
    return y;
}

TEST(ExactCases, FreeFallWithDrag) {
    ClothParameters parameters = net({2, 2}, Real(0.05), {});
    parameters.drag = Real(0.02);
    const ClothModel model = make_cloth_model(parameters);
    ClothState start = make_rest_state(parameters);
    start.v.col(1).setConstant(3);
    constexpr Real h = Real(0.05);
    constexpr int steps = 40;
    const Real rate = parameters.drag / model.particle_mass, limit = -Real(9.81) / rate;

    // (way, speed above the limit): the limit itself adds nothing but its way, except where x takes the new speed
    Map fall = Map::Zero();
    fall(0, 1) = 1;
    fall(1, 1) = -rate;
    for (const Kind kind : values_of<Kind>()) {
        const Pair fallen = linear_solution(kind, fall, h, {0, 3 - limit}, steps);
        const ClothState now = after(accurate(kind), model, start, steps * h, steps);
        for (int p = 0; p < 4; ++p) {
            EXPECT_NEAR(now.x(p, 1), fallen[0] + limit * steps * h, 1e-10) << name_of(kind);
            EXPECT_NEAR(now.v(p, 1), fallen[1] + limit, 1e-10) << name_of(kind);
            EXPECT_EQ(now.x(p, 0), start.x(p, 0)) << name_of(kind);
        }
    }
}

TEST(ExactCases, DampedOscillator) {
    // Two particles and one spring, and beside them the same again; their other springs stay as long as they are
    constexpr Real k = 50, c = Real(0.1), h = Real(0.002);
    constexpr int steps = 300;
    const ClothParameters parameters = net({2, 2}, Real(0.05), {k, c});
    ClothModel model = make_cloth_model(parameters);
    model.gravity.setZero();
    ClothState start = make_rest_state(parameters);
    for (const int p : {0, 2}) start.x(p, 0) -= Real(0.05), start.x(p + 1, 0) += Real(0.05);
    const auto elongation = [](const ClothState& state) -> Pair {
        return {state.x(1, 0) - state.x(0, 0) - 1, state.v(1, 0) - state.v(0, 0)};
    };
    const Real m = model.particle_mass;
    Map rate;
    rate << 0, 1, -2 * k / m, -2 * c / m;
    for (const Kind kind : values_of<Kind>()) {
        const Pair expected = linear_solution(kind, rate, h, {Real(0.1), 0}, steps);
        const Pair found = elongation(after(accurate(kind), model, start, steps * h, steps));
        EXPECT_NEAR(found[0], expected[0], 1e-10) << name_of(kind);
        EXPECT_NEAR(found[1], expected[1], 1e-8) << name_of(kind);
    }

    // The exact solution itself
    const Real decay = c / m, turn = std::sqrt(2 * k / m - decay * decay), t = steps * h;
    const Real truth = Real(0.1) * std::exp(-decay * t) * (std::cos(turn * t) + decay / turn * std::sin(turn * t));
    const ClothState now = after(accurate(Kind::DormandPrince), model, start, t, 3);
    EXPECT_NEAR(elongation(now)[0], truth, 1e-10);
}

}  // namespace
}  // namespace drape
