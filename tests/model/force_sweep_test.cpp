// The sweep over all springs, on grids that fill no vector, on every kind of processor and number of threads.

#include "drape/model/force_sweep.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "drape/model/forces.h"
#include "support/allocations.h"
#include "support/cloths.h"

namespace drape {
namespace {

using test::odd_grids;

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

TEST(ForceSweep, RemembersNothingOfTheSweepBefore) {
    for (const Grid grid : odd_grids) {
        MovingCloth cloth(grid);
        const Points before = cloth.forces(1);
        ForceSweep sweep(grid, Kernels::Vector);
        EXPECT_EQ(cloth.forces(sweep), before);
        EXPECT_EQ(cloth.forces(sweep), before);
        for (SpringLaw* law : {&cloth.model.structural, &cloth.model.shear, &cloth.model.bend}) {
            *law = {};
            EXPECT_EQ(cloth.forces(sweep), cloth.forces(1)) << grid.nx << " x " << grid.ny;
        }
    }
}

TEST(ForceSweep, GivesTheSameBitsWithEveryKindOfVector) {
    const std::int64_t all = hwy::SupportedTargets();
    for (const Grid grid : odd_grids) {
        const MovingCloth cloth(grid);
        const Points best = cloth.forces(1);
        int kinds = 0;
        for (std::int64_t targets = all; targets != 0; targets &= targets - 1, ++kinds) {
            hwy::SetSupportedTargetsForTest(targets & -targets);
            EXPECT_EQ(cloth.forces(1), best)
                << grid.nx << " x " << grid.ny << ": " << hwy::TargetName(targets & -targets);
        }
        hwy::SetSupportedTargetsForTest(0);
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

TEST(ForceSweep, AllocatesNothing) {
    const MovingCloth cloth({300, 200});
    ForceSweep sweep(cloth.model.grid, Kernels::Vector, 3);
    Points f(cloth.state.x.rows(), 3);
    const auto before = test::allocations();
    for (int round = 0; round < 3; ++round) {
        sweep(cloth.model, cloth.state.x, cloth.state.v, [&](const ForceRun& run) { run.of(f) = run.accelerations(); });
    }
    EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace drape
