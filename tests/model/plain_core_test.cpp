// The vector kernels of forces, Jacobians and energy are held to the plain code, on grids that fill no vector and on
// every kind of processor that this one can stand for. Those of whole steps are in integrate/kernels_test.cpp.

#include <gtest/gtest.h>

#include "drape/model/energy.h"
#include "drape/model/force_sweep.h"
#include "drape/model/forces.h"
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

    [[nodiscard]] Points forces(int threads = 1) const {
        Points f = Points::Constant(state.x.rows(), 3, -1);
        ForceSweep(model.grid, Kernels::Vector, threads).compute(model, state.x, state.v, f);
        return f;
    }

    [[nodiscard]] Points plain_forces() const {
        Points f(state.x.rows(), 3);
        compute_forces(model, state.x, state.v, f);
        return f;
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

Real difference(const Points& a, const Points& b) { return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff(); }

TEST(PlainCore, GivesTheJacobiansOfTheKernels) {
    for (const Grid grid : odd_grids) {
        const Moving cloth(grid);
        for (const Hessian hessian : {Hessian::Clamped, Hessian::Exact}) {
            const Points plain = cloth.product(hessian, Kernels::Plain);
            const Points best = cloth.product(hessian, Kernels::Vector);
            EXPECT_LT(difference(best, plain), rounding) << grid.nx << " x " << grid.ny;
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

TEST(ForceSweep, GivesWhatThePlainCodeGives) {
    for (const Grid grid : odd_grids) {
        Moving cloth(grid);
        for (const Real air : {Real(0), Real(1.2)}) {
            cloth.model.air.density = air;
            EXPECT_LT(difference(cloth.forces(), cloth.plain_forces()), rounding) << grid.nx << " x " << grid.ny;
        }
    }
    for (SpringLaw ClothModel::*law : {&ClothModel::structural, &ClothModel::shear, &ClothModel::bend}) {
        Moving cloth({31, 17});
        cloth.model.*law = {};
        EXPECT_LT(difference(cloth.forces(), cloth.plain_forces()), rounding) << "without springs of a kind";
    }
}

TEST(ForceSweep, GivesTheSameBitsWithEveryKindOfVector) {
    for (const Grid grid : odd_grids) {
        const Moving cloth(grid);
        const Points best = cloth.forces();
        const int kinds = with_every_kind_of_vector(
            [&](const char* kind) { EXPECT_EQ(cloth.forces(), best) << grid.nx << " x " << grid.ny << ": " << kind; });
        EXPECT_GE(kinds, 2) << "this processor has no vectors to compare with";
    }
}

TEST(ForceSweep, GivesTheSameBitsWithAnyNumberOfThreadsAndWhereTheStateIsOverwrittenOnTheWay) {
    for (const Grid grid : {Grid{31, 17}, Grid{300, 200}, Grid{2, 30000}, Grid{30000, 2}}) {
        for (const Real air : {Real(0), Real(1.2)}) {
            Moving cloth(grid);
            cloth.model.air.density = air;
            const Points expected = cloth.forces();
            for (const int threads : {1, 2, 3, 7}) {
                EXPECT_EQ(cloth.forces(threads), expected) << grid.nx << " x " << grid.ny << ", threads: " << threads;
                ClothState state = cloth.state;
                Points f(state.x.rows(), 3);
                ForceSweep sweep(grid, Kernels::Vector, threads);
                sweep(cloth.model, state.x, state.v, [&](const ForceRun& run) {
                    run.of(f) = run.forces();
                    run.of(state.x) = run.of(state.v) = 1e9;
                });
                EXPECT_EQ(f, expected) << "overwritten, " << grid.nx << " x " << grid.ny << ", threads: " << threads;
            }
        }
    }
}

}  // namespace
}  // namespace drape
