// Every method gives the same motion with the vector kernels and with the plain code, to rounding.

#include <gtest/gtest.h>

#include "drape/integrate/integrator.h"
#include "drape/integrate/stability.h"
#include "integrate/damped_sheet.h"

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

    /// How far the two ways are apart, in parts of the largest displacement and the largest speed.
    [[nodiscard]] Real difference(IntegratorParameters method) const {
        const auto after_steps = [&](Kernels kernels) {
            method.kernels = kernels;
            return test::after(method, model, start, Real(3e-4), 3);
        };
        const ClothState vector = after_steps(Kernels::Vector), plain = after_steps(Kernels::Plain);
        const Real of_x = (vector.x - plain.x).cwiseAbs().maxCoeff() / (plain.x - start.x).cwiseAbs().maxCoeff();
        const Real of_v = (vector.v - plain.v).cwiseAbs().maxCoeff() / plain.v.cwiseAbs().maxCoeff();
        return std::max(of_x, of_v);
    }
};

TEST(Kernels, MoveAClothAsThePlainCodeDoesByEveryMethod) {
    for (const Grid grid : {Grid{2, 2}, Grid{2, 9}, Grid{9, 2}, Grid{3, 3}, Grid{21, 13}, Grid{261, 4}}) {
        const Flag flag(grid);
        for (const IntegratorParameters& method : test::all_methods()) {
            const Real difference = flag.difference(method);
            EXPECT_LT(difference, Real(1e-10)) << test::text_of(method) << ", " << grid.nx << " x " << grid.ny;
            if (grid.nx != 21) continue;
            EXPECT_GT(difference, 0) << test::text_of(method) << " uses the same code both ways";
        }
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
