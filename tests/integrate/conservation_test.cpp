// What methods keep, to rounding or within bounds.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "drape/model/energy.h"
#include "integrate/damped_sheet.h"

namespace drape {
namespace {

using test::after;
using test::Sheet;

/// sum x x v over the particles.
Vec3 spin_of(const ClothState& state) {
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index p = 0; p < state.x.rows(); ++p) {
        sum += state.x.row(p).transpose().cross(state.v.row(p).transpose());
    }
    return sum;
}

TEST(AngularMomentum, IsKeptToRoundingWherePositionsMoveByTheVelocityBetweenForces) {
    // A damped sheet that nothing from outside acts on
    Sheet sheet;
    sheet.parameters.pinned.kind = Pins::Kind::None;
    sheet.parameters.drag = 0;
    sheet.model = make_cloth_model(sheet.parameters);
    sheet.model.gravity.setZero();
    const Real scale = sheet.start.x.rowwise().norm().dot(sheet.start.v.rowwise().norm());
    for (const auto kind : {IntegratorKind::SymplecticEuler, IntegratorKind::VelocityVerlet}) {
        const ClothState now = after({.kind = kind}, sheet.model, sheet.start, 0.2, 400);
        EXPECT_LT((spin_of(now) - spin_of(sheet.start)).norm(), 1e-12 * scale) << name_of(kind);
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
    EXPECT_FALSE(largest_energy_error(IntegratorKind::ExplicitEuler) < 1);
}

}  // namespace
}  // namespace drape
