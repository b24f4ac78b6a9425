#include "integrate/multigrid.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <random>

#include "drape/base/exact_math.h"
#include "integrate/grid_factor.h"
#include "integrate/krylov.h"

namespace drape {
namespace {

/// The system of a backward Euler step of a wrinkled sheet of 1 m and 0.2 kg.
struct System {
    ClothModel model;
    Jacobian jacobian;
    Real s = Real(1) / 60;
    ClothState state;

    System(const Grid& grid, Real stiffness, const Pins& pins, Real wave)
        : model(make_cloth_model({.particles = grid,
                                  .mass = Real(0.2),
                                  .pinned = pins,
                                  .structural = {stiffness, 0},
                                  .shear = {stiffness / 2, 0},
                                  .bend = {stiffness / 10, 0}})),
          jacobian(grid, Hessian::Clamped, Kernels::Vector) {
        state = make_rest_state({.particles = grid, .pinned = {}});
        for (Eigen::Index p = 0; p < state.x.rows(); ++p) {
            const Real x = state.x(p, 0), z = state.x(p, 2);
            state.x(p, 1) += wave * std::sin(9 * x + 4 * z) + wave / 3 * std::sin(31 * z - 17 * x);
            state.x(p, 0) *= Real(1.001);
        }
        jacobian.linearise(model, state.x, state.v);
    }

    void clear_pinned(Points& y) const {
        for (int p = 0; p < model.grid.particles(); ++p) {
            if (model.pinned(p)) y.row(p).setZero();
        }
    }
    void product(const Points& u, Points& y) const {
        y = model.particle_mass * u;
        jacobian.add_product(s * s, s, u, y);
        clear_pinned(y);
    }
    [[nodiscard]] Points random_side() const {
        std::mt19937 random(7);
        Points b(model.grid.particles(), 3);
        for (Real& value : b.reshaped()) value = uniform<Real>(random) - Real(0.5);
        clear_pinned(b);
        return b;
    }
};

SolveReport solve(const System& system, const Points& b, Points& x, Real tolerance, Kernels kernels = Kernels::Vector) {
    Multigrid multigrid(system.model.grid, kernels);
    multigrid.build(system.model, system.jacobian, system.s * system.s, system.s);
    krylov::ConjugateGradients gradients(system.model.grid.particles());
    return gradients.solve(
        b, x, tolerance, 200, [&](const Points& u, Points& y) { system.product(u, y); },
        [&](const Points& r, Points& z) { multigrid.cycle(r, z); });
}

TEST(Multigrid, SolvesWhatFactorsSolveOnGridsOfEveryShape) {
    const Pins none{Pins::Kind::None, {}}, two{Pins::Kind::Two, {}}, row{Pins::Kind::Row, {}},
        some{Pins::Kind::List, {3, 17, 18, 40, 41, 55}};
    for (const Grid& grid : {Grid{33, 33}, {32, 40}, {2, 100}, {100, 2}, {3, 50}, {7, 9}, {65, 20}}) {
        for (const Pins& pins : {none, two, row, some}) {
            const System system(grid, 1000, pins, Real(0.01));
            const Points b = system.random_side();
            Points x(b.rows(), 3), exact(b.rows(), 3);
            const SolveReport report = solve(system, b, x, Real(1e-9));
            EXPECT_EQ(report.unconverged, 0) << grid.nx << " x " << grid.ny;
            EXPECT_LE(report.iterations, 60) << grid.nx << " x " << grid.ny;
            GridFactor factor(grid);
            factor.factorise(system.model, system.jacobian, system.s * system.s, system.s);
            factor.solve(b, exact);
            EXPECT_LT((x - exact).norm(), 1e-6 * exact.norm()) << grid.nx << " x " << grid.ny;
        }
    }
}

TEST(Multigrid, TakesAboutAsManyIterationsOnEveryGridAndStiffness) {
    for (const int side : {32, 64, 128}) {
        for (const Real stiffness : {1e2, 1e4, 1e6}) {
            const System system({side, side}, stiffness, {Pins::Kind::Two, {}}, Real(0.005));
            const Points b = system.random_side();
            Points x(b.rows(), 3);
            EXPECT_LE(solve(system, b, x, Real(1e-4)).iterations, 20) << side << ", " << stiffness;
        }
    }
}

// Across such a sheet nothing but its mass resists, which single precision loses beside the springs.
TEST(Multigrid, SolvesASlackTiltedStiffSheet) {
    for (const Real stiffness : {1e5, 1e6}) {
        System system({96, 96}, stiffness, {Pins::Kind::None, {}}, 0);
        const Eigen::AngleAxis<Real> turn(Real(0.7), Vec3(1, 2, 3).normalized());
        system.state.x = Real(0.998) * system.state.x * turn.toRotationMatrix().transpose();
        system.jacobian.linearise(system.model, system.state.x, system.state.v);
        const Points b = system.random_side();
        Points x(b.rows(), 3), product(b.rows(), 3);
        const SolveReport report = solve(system, b, x, Real(1e-6));
        EXPECT_EQ(report.unconverged, 0) << stiffness;
        EXPECT_LE(report.iterations, 100) << stiffness;
        system.product(x, product);
        EXPECT_LT((product - b).norm(), 1e-3 * b.norm()) << stiffness;
    }
}

TEST(Multigrid, HasTheSameBitsByPlainCode) {
    for (const Grid& grid : {Grid{33, 30}, {2, 101}}) {
        const System system(grid, 1000, {Pins::Kind::Two, {}}, Real(0.01));
        const Points b = system.random_side();
        Points x(b.rows(), 3), plain(b.rows(), 3);
        solve(system, b, x, Real(1e-6));
        solve(system, b, plain, Real(1e-6), Kernels::Plain);
        EXPECT_EQ(x, plain) << grid.nx;
    }
}

/// A cycle for a system.
Points cycle_of(Multigrid& multigrid, const System& system, const Points& b) {
    Points z(b.rows(), 3);
    multigrid.build(system.model, system.jacobian, system.s * system.s, system.s);
    multigrid.cycle(b, z);
    return z;
}

TEST(Multigrid, ForgetsWhatWasNoNumber) {
    for (const Grid& grid : {Grid{33, 30}, {2, 200}, {21, 19}}) {
        const System system(grid, 1000, {Pins::Kind::Two, {}}, Real(0.01));
        const Points b = system.random_side();
        Points bad = b;
        bad(grid.nx + 1, 1) = std::numeric_limits<Real>::quiet_NaN();
        Multigrid fresh(grid, Kernels::Vector), used(grid, Kernels::Vector);
        cycle_of(used, system, bad);
        EXPECT_EQ(cycle_of(used, system, b), cycle_of(fresh, system, b)) << grid.nx;
    }
}

TEST(Multigrid, ForgetsSpringsThatAreGone) {
    const Grid grid{30, 30};
    System used(grid, 1000, {Pins::Kind::Two, {}}, Real(0.01));
    used.model.bend = {};
    used.jacobian.linearise(used.model, used.state.x, used.state.v);
    System fresh = used;
    fresh.jacobian = Jacobian(grid, Hessian::Clamped, Kernels::Vector);
    fresh.jacobian.linearise(fresh.model, fresh.state.x, fresh.state.v);
    const Points b = used.random_side();
    Multigrid one(grid, Kernels::Vector), other(grid, Kernels::Vector);
    EXPECT_EQ(cycle_of(one, used, b), cycle_of(other, fresh, b));
}

// The last iteration takes the residual of the recursion far below what rounding leaves of the true one.
TEST(ConjugateGradients, HaveConvergedWhereTheyEndBelowRounding) {
    Points b = Points::Ones(30, 3), x(30, 3);
    krylov::ConjugateGradients gradients(30);
    const auto apply = [](const Points& u, Points& y) {
        for (Eigen::Index p = 0; p < u.rows(); ++p) y.row(p) = static_cast<Real>(1 + p % 3) / 3 * u.row(p);
    };
    const SolveReport report = gradients.solve(b, x, Real(1e-4), 200, apply, [](const Points& r, Points& z) { z = r; });
    EXPECT_EQ(report.unconverged, 0);
    EXPECT_LE(report.iterations, 4);
}

}  // namespace
}  // namespace drape
