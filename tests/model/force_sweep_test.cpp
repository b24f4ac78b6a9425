// The sweep over all springs, on grids that fill no vector, on every kind of processor and number of threads.

#include "drape/model/force_sweep.h"

#include <gtest/gtest.h>

#include "drape/model/forces.h"
#include "support/cloths.h"
#include "support/vector_kinds.h"

namespace drape {
namespace {

using test::odd_grids;
using test::with_every_kind_of_vector;

struct MovingCloth {
    ClothModel model;
    ClothState state;

    explicit MovingCloth(const Grid& grid) {
        const ClothParameters parameters = test::unlike_springs(grid);
        std::mt19937 random(5);
        model = make_cloth_model(parameters);
        state = test::random_state(parameters, random);
    }

    [[nodiscard]] Points forces(int threads) const {
        ForceSweep sweep(model.grid, Kernels::Vector, threads);
        return forces(sweep);
    }

    [[nodiscard]] Points forces(ForceSweep& sweep) const {
        Points f = Points::Constant(state.x.rows(), 3, -1);
        sweep.compute(model, state.x, state.v, f);
        return f;
    }

    [[nodiscard]] Points plain_forces() const {
        Points f(state.x.rows(), 3);
        compute_forces(model, state.x, state.v, f);
        return f;
    }
};

Real difference(const Points& a, const Points& b) { return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff(); }

constexpr Real sweep_rounding = 1e-12;

TEST(ForceSweep, GivesWhatThePlainCodeGives) {
    for (const Grid grid : odd_grids) {
        MovingCloth cloth(grid);
        for (const Real air : {Real(0), Real(1.2)}) {
            cloth.model.air = {Vec3(3, -1, 2), air};
            EXPECT_LT(difference(cloth.forces(1), cloth.plain_forces()), sweep_rounding) << grid.nx << " x " << grid.ny;
        }
    }
    for (SpringLaw ClothModel::*law : {&ClothModel::structural, &ClothModel::shear, &ClothModel::bend}) {
        MovingCloth cloth({31, 17});
        cloth.model.*law = {};
        EXPECT_LT(difference(cloth.forces(1), cloth.plain_forces()), sweep_rounding) << "without springs of a kind";
    }
}

TEST(ForceSweep, GivesTheSameBitsWithEveryKindOfVector) {
    for (const Grid grid : odd_grids) {
        const MovingCloth cloth(grid);
        const Points best = cloth.forces(1);
        const int kinds = with_every_kind_of_vector(
            [&](const char* kind) { EXPECT_EQ(cloth.forces(1), best) << grid.nx << " x " << grid.ny << ": " << kind; });
        EXPECT_GE(kinds, 2) << "this processor has no vectors to compare with";
    }
}

TEST(ForceSweep, GivesTheSameBitsWithAnyNumberOfThreadsAndWhereTheStateIsOverwrittenOnTheWay) {
    for (const Grid grid : {Grid{31, 17}, Grid{300, 200}, Grid{2, 30000}, Grid{30000, 2}}) {
        for (const Real air : {Real(0), Real(1.2)}) {
            MovingCloth cloth(grid);
            cloth.model.air = {Vec3(3, -1, 2), air};
            const Points expected = cloth.forces(1);
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
