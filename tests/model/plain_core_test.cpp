// The vector kernels of Jacobians and energy are held to the plain code, on every kind of processor that this one can
// stand for. Those of the forces are in force_sweep_test.cpp, those of whole steps in integrate/kernels_test.cpp.

#include <gtest/gtest.h>

#include "drape/model/energy.h"
#include "drape/model/jacobian.h"
#include "support/cloths.h"
#include "support/vector_kinds.h"

namespace drape {
namespace {

using test::odd_grids;
using test::with_every_kind_of_vector;
constexpr Real rounding = 1e-12;

/// A cloth in wind with nothing special about it, two held particles that move included.
struct Moving {
    ClothModel model;
    ClothState state;

    explicit Moving(const Grid& grid) {
        ClothParameters parameters = test::unlike_springs(grid);
        parameters.pinned.kind = Pins::Kind::Two;
        std::mt19937 random(5);
        model = make_cloth_model(parameters);
        model.air = {Vec3(3, -1, 2), Real(1.2)};
        state = test::random_state(parameters, random);
    }

    [[nodiscard]] Points product(Hessian hessian, Kernels kernels) const {
        Jacobian jacobian(model.grid, hessian, kernels);
        jacobian.linearise(model, state.x, state.v);
        Points y = Points::Zero(state.x.rows(), 3);
        jacobian.add_product(2, 3, state.v, y);
        return y;
    }

    [[nodiscard]] std::array<double, 7> energies(Kernels kernels) const {
        Points scratch(state.x.rows(), 3);
        const auto [energy, power] = compute_energy_flow(model, state.x, state.v, scratch, kernels);
        return {energy.kinetic, energy.gravity, energy.spring, power.damping, power.drag, power.wind, power.hand};
    }
};

TEST(PlainCore, GivesTheJacobiansOfTheKernels) {
    for (const Grid grid : odd_grids) {
        const Moving cloth(grid);
        for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
            const Points plain = cloth.product(hessian, Kernels::Plain);
            const Points best = cloth.product(hessian, Kernels::Vector);
            EXPECT_LT((best - plain).cwiseAbs().maxCoeff(), rounding * plain.cwiseAbs().maxCoeff())
                << grid.nx << " x " << grid.ny;
            with_every_kind_of_vector(
                [&](const char* told) { EXPECT_EQ(cloth.product(hessian, Kernels::Vector), best) << told; });
        }
    }
}

TEST(PlainCore, GivesTheEnergyOfTheKernels) {
    for (const Grid grid : odd_grids) {
        const Moving cloth(grid);
        const auto plain = cloth.energies(Kernels::Plain), best = cloth.energies(Kernels::Vector);
        for (std::size_t term = 0; term < plain.size(); ++term) {
            EXPECT_NEAR(best[term], plain[term], rounding * std::abs(plain[term])) << grid.nx << " " << term;
            EXPECT_NE(plain[term], 0) << term;
        }
        with_every_kind_of_vector([&](const char* told) { EXPECT_EQ(cloth.energies(Kernels::Vector), best) << told; });
    }
}

}  // namespace
}  // namespace drape
