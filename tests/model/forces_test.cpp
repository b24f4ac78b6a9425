#include "drape/model/forces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "drape/model/energy.h"
#include "drape/model/stretch_limit.h"
#include "support/cloths.h"

namespace drape {
namespace {

/// The design's formulas, spring by spring, with no stencil and no vectorised loop.
Points forces_by_definition(const ClothModel& model, const ClothState& state) {
    const Grid grid = model.grid;
    Points f(grid.particles(), 3);
    for (int p = 0; p < grid.particles(); ++p) {
        f.row(p) = (model.particle_mass * model.gravity).transpose() - model.drag * state.v.row(p);
    }
    const auto add = [&](int i, int j, int di, int dj, const SpringLaw& law) {
        if (i + di < 0 || i + di >= grid.nx || j + dj >= grid.ny) return;
        const int a = grid.particle(i, j), b = grid.particle(i + di, j + dj);
        const Vec3 d = (state.x.row(a) - state.x.row(b)).transpose();
        if (d.norm() == 0) return;
        const Vec3 n = d.normalized();
        const Vec3 relative = (state.v.row(a) - state.v.row(b)).transpose();
        const Real rest = std::hypot(di * model.hx, dj * model.hy);
        const Vec3 force = -(law.stiffness * (d.norm() - rest) + law.damping * n.dot(relative)) * n;
        f.row(a) += force.transpose();
        f.row(b) -= force.transpose();
    };
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            add(i, j, 1, 0, model.structural), add(i, j, 0, 1, model.structural);
            add(i, j, 1, 1, model.shear), add(i, j, -1, 1, model.shear);
            add(i, j, 2, 0, model.bend), add(i, j, 0, 2, model.bend);
        }
    }
    for (int t = 0; model.air.density > 0 && t < grid.triangles(); ++t) {
        const auto [a, b, c] = grid.triangle_corners(t);
        const Vec3 cross =
            (state.x.row(b) - state.x.row(a)).transpose().cross((state.x.row(c) - state.x.row(a)).transpose());
        const Real area = cross.norm() / 2;
        const Vec3 n = cross.normalized();
        const Vec3 mean = (state.v.row(a) + state.v.row(b) + state.v.row(c)).transpose() / 3;
        const Real flow = (model.air.velocity - mean).dot(n);
        const Vec3 force = 1.17 / 2 * model.air.density * std::abs(flow) * flow * area * n;
        for (const int corner : {a, b, c}) f.row(corner) += force.transpose() / 3;
    }
    return f;
}

TEST(Forces, AreThoseOfTheDesignOnGridsOfAnyShape) {
    std::mt19937 random(1);
    for (const Grid grid : {Grid{2, 2}, Grid{3, 2}, Grid{2, 5}, Grid{17, 9}, Grid{300, 4}, Grid{30, 30}}) {
        const ClothParameters parameters = test::unlike_springs(grid);
        ClothModel model = make_cloth_model(parameters);
        for (const Real density : {0.0, 1.2}) {
            model.air = {Vec3(3, -1, 2), density};
            const ClothState state = test::random_state(parameters, random);
            Points f(grid.particles(), 3);
            compute_forces(model, state.x, state.v, f);
            const Points expected = forces_by_definition(model, state);
            EXPECT_LT((f - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff())
                << grid.nx << " x " << grid.ny << ", air " << density;
        }
    }
}

TEST(Forces, VanishInASpringOfZeroLength) {
    ClothParameters parameters;
    parameters.particles = {3, 3};
    ClothModel model = make_cloth_model(parameters);
    model.gravity.setZero();
    model.air = {Vec3(1, 2, 3), 1.2};
    ClothState state = make_rest_state(parameters);
    state.x.setConstant(0.7);
    state.v.setRandom();
    Points f(9, 3);
    compute_forces(model, state.x, state.v, f);
    EXPECT_TRUE(f.isApprox(-model.drag * state.v)) << f;
}

TEST(Energy, OfAStretchedSheetIsKnown) {
    ClothParameters parameters;
    parameters.particles = {2, 2};
    parameters.mass = 4;
    parameters.structural = {10, 0};
    parameters.shear = {0, 0};
    parameters.bend = {0, 0};
    const ClothModel model = make_cloth_model(parameters);
    ClothState state = make_rest_state(parameters);
    state.x *= 1.5;
    state.v.col(1).setConstant(2);
    state.x.col(1).setConstant(3);
    const Energy energy = compute_energy(model, state, Kernels::Vector);
    EXPECT_DOUBLE_EQ(energy.kinetic, 8);
    EXPECT_DOUBLE_EQ(energy.gravity, 4 * 9.81 * 3);
    EXPECT_DOUBLE_EQ(energy.spring, 4 * 0.5 * 10 * 0.25);
    EXPECT_DOUBLE_EQ(largest_stretch(model, state.x), 0.5);
}

}  // namespace
}  // namespace drape
