// Every method gives the same motion with the vector kernels and with the plain code, to rounding.

#include <gtest/gtest.h>

#include "drape/integrate/integrator.h"
#include "drape/integrate/stability.h"
#include "support/cloths.h"

namespace drape {
namespace {

/// A cloth in wind that hangs on two corners and moves, after some steps.
struct Flag {
    ClothParameters parameters;
    ClothModel model;
    ClothState start;

    explicit Flag(const Grid& grid) {
        parameters.particles = grid;
        parameters.pinned.kind = Pins::Kind::Two;
        parameters.structural.damping = Real(0.3);
        parameters.drag = Real(1e-3);
        model = make_cloth_model(parameters);
        model.air = {Vec3(3, -1, 2), Real(1.2)};
        std::mt19937 random(3);
        start = test::random_state(parameters, random);
    }

    [[nodiscard]] ClothState after_steps(IntegratorParameters method, Kernels kernels) const {
        constexpr int steps = 3;
        method.kernels = kernels;
        const auto integrator = make_integrator(method, model.grid);
        ClothState state = start;
        for (int step = 0; step < steps; ++step) integrator->step(model, state, Real(1e-4));
        return state;
    }

    /// How far the two ways are apart, in parts of the largest displacement and the largest speed.
    [[nodiscard]] Real difference(const IntegratorParameters& method) const {
        const ClothState vector = after_steps(method, Kernels::Vector), plain = after_steps(method, Kernels::Plain);
        const Real of_x = (vector.x - plain.x).cwiseAbs().maxCoeff() / (plain.x - start.x).cwiseAbs().maxCoeff();
        const Real of_v = (vector.v - plain.v).cwiseAbs().maxCoeff() / plain.v.cwiseAbs().maxCoeff();
        return std::max(of_x, of_v);
    }
};

std::vector<IntegratorParameters> all_methods() {
    std::vector<IntegratorParameters> methods;
    for (int kind = 0; kind < static_cast<int>(names_of<IntegratorKind>().size()); ++kind) {
        methods.push_back({.kind = static_cast<IntegratorKind>(kind)});
    }
    for (const IntegratorKind kind :
         {IntegratorKind::BackwardEuler, IntegratorKind::ImplicitMidpoint, IntegratorKind::Bdf2}) {
        methods.push_back({.kind = kind, .hessian = Hessian::Exact});
    }
    return methods;
}

TEST(Kernels, MoveAClothAsThePlainCodeDoesByEveryMethod) {
    for (const Grid grid : {Grid{2, 2}, Grid{2, 9}, Grid{9, 2}, Grid{3, 3}, Grid{21, 13}, Grid{261, 4}}) {
        const Flag flag(grid);
        for (const IntegratorParameters& method : all_methods()) {
            EXPECT_LT(flag.difference(method), Real(1e-10))
                << name_of(method.kind) << ", " << grid.nx << " x " << grid.ny;
        }
    }
}

TEST(Kernels, ArePlainWhereTheMethodIsToldSo) {
    const Flag flag({21, 13});
    for (const IntegratorParameters& method : all_methods()) {
        EXPECT_GT(flag.difference(method), 0) << name_of(method.kind) << " is given the same bits both ways";
    }
}

TEST(PlainCore, GivesTheStepLimitOfTheKernels) {
    ClothParameters parameters;
    parameters.particles = {70, 9};
    const ClothModel model = make_cloth_model(parameters);
    const ClothState state = make_rest_state(parameters);
    const Real plain = predicted_limit(model, state, IntegratorKind::SymplecticEuler, Kernels::Plain).step;
    const Real vector = predicted_limit(model, state, IntegratorKind::SymplecticEuler, Kernels::Vector).step;
    EXPECT_NEAR(plain, vector, 1e-6 * vector);
}

}  // namespace
}  // namespace drape
