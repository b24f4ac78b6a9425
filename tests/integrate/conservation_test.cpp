// What methods keep, to rounding or within bounds.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "drape/model/energy.h"
#include "drape/model/forces.h"
#include "integrate/damped_sheet.h"

namespace drape {
namespace {

using test::after;
using test::Sheet;

/// A damped sheet that nothing from outside acts on.
struct FreeSheet : Sheet {
    FreeSheet() {
        parameters.pinned.kind = Pins::Kind::None;
        parameters.drag = 0;
        model = make_cloth_model(parameters);
        model.gravity.setZero();
    }
};

/// sum a x b over the particles.
Vec3 moment(const Points& a, const Points& b) {
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index p = 0; p < a.rows(); ++p) sum += a.row(p).transpose().cross(b.row(p).transpose());
    return sum;
}

/// The change of angular momentum, in parts of what it would be if all particles moved across their radius.
Real spin_gained(const IntegratorParameters& parameters, Real time, int steps) {
    const FreeSheet sheet;
    const ClothState now = after(parameters, sheet.model, sheet.start, time, steps);
    const Real scale = sheet.start.x.rowwise().norm().dot(sheet.start.v.rowwise().norm());
    return (moment(now.x, now.v) - moment(sheet.start.x, sheet.start.v)).norm() / scale;
}

TEST(AngularMomentum, IsKeptToRoundingWherePositionsMoveByTheVelocityBetweenForces) {
    EXPECT_LT(spin_gained({.kind = IntegratorKind::SymplecticEuler}, 0.2, 400), 1e-12);
    EXPECT_LT(spin_gained({.kind = IntegratorKind::VelocityVerlet}, 0.2, 400), 1e-12);
}

TEST(AngularMomentum, IsKeptByRungeKuttaMethodsAsFarAsTheyAreAccurate) {
    EXPECT_LT(spin_gained({.kind = IntegratorKind::Rk4}, 4e-3, 400), 1e-12);
    EXPECT_LT(spin_gained({.kind = IntegratorKind::DormandPrince, .tolerance = Real(1e-13)}, 4e-3, 1), 1e-12);
    const Real coarse = spin_gained({.kind = IntegratorKind::Rk4}, 0.2, 100);
    const Real fine = spin_gained({.kind = IntegratorKind::Rk4}, 0.2, 200);
    EXPECT_GT(std::log2(coarse / fine), 3.7);
}

TEST(AngularMomentum, GrowsUnderExplicitEulerByTheMomentOfForcesAboutVelocities) {
    const FreeSheet sheet;
    constexpr Real h = 1e-3;
    ClothState state = sheet.start;
    Points f(state.x.rows(), 3);
    const auto integrator = make_integrator({.kind = IntegratorKind::ExplicitEuler}, sheet.model.grid);
    const Real scale = state.x.rowwise().norm().dot(state.v.rowwise().norm());
    for (int step = 0; step < 50; ++step) {
        compute_forces(sheet.model, state.x, state.v, f);
        const Vec3 gain = h * h * moment(state.v, f) / sheet.model.particle_mass;
        const Vec3 before = moment(state.x, state.v);
        integrator->step(sheet.model, state, h);
        const Vec3 gained = moment(state.x, state.v) - before;
        EXPECT_LT((gained - gain).norm(), 1e-12 * scale);
        EXPECT_GT(gained.norm(), 1e-8 * scale);
    }
}

/// The largest error of the energy over 1e5 steps, in parts of what moves between kinetic and spring energy.
Real largest_energy_error(IntegratorKind kind) {
    Sheet sheet({3, 3});
    sheet.undamp();
    const Energy first = compute_energy(sheet.model, sheet.start, Kernels::Vector);
    const auto integrator = make_integrator({.kind = kind}, sheet.model.grid);
    ClothState state = sheet.start;
    Real largest = 0;
    for (int step = 1; step <= 100000; ++step) {
        integrator->step(sheet.model, state, 1e-3);
        if (step % 100 != 0) continue;
        const Real error = std::abs(compute_energy(sheet.model, state, Kernels::Vector).total() - first.total());
        if (!std::isfinite(error)) return error;
        largest = std::max(largest, error);
    }
    return largest / (first.kinetic + first.spring);
}

TEST(SymplecticMethods, KeepTheEnergyBoundedOverAHundredThousandSteps) {
    EXPECT_LT(largest_energy_error(IntegratorKind::SymplecticEuler), 0.05);
    EXPECT_LT(largest_energy_error(IntegratorKind::VelocityVerlet), 2e-3);
}

TEST(SymplecticMethods, AreToldFromExplicitEulerByTheirEnergy) {
    EXPECT_FALSE(largest_energy_error(IntegratorKind::ExplicitEuler) < 1);
}

}  // namespace
}  // namespace drape
