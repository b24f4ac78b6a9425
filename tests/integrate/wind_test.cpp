// Sheets in the wind, whose force resists velocities, by every method.

#include <gtest/gtest.h>

#include <cmath>

#include "drape/integrate/stability.h"
#include "drape/model/forces.h"
#include "integrate/damped_sheet.h"

namespace drape {
namespace {

constexpr IntegratorKind unlimited_kinds[] = {IntegratorKind::BackwardEuler, IntegratorKind::ImplicitMidpoint,
                                              IntegratorKind::Bdf2, IntegratorKind::Xpbd,
                                              IntegratorKind::ProjectiveDynamics};

/// A sheet of 1 m x 1 m that hangs from its first row, in wind across it.
struct BlownFlag {
    ClothModel model;
    ClothState start;

    BlownFlag(Real mass, Real speed) {
        ClothParameters parameters;
        parameters.particles = {8, 8};
        parameters.mass = mass;
        parameters.plane = Plane::XY;
        parameters.pinned.kind = Pins::Kind::Row;
        parameters.drag = Real(0.02);
        model = make_cloth_model(parameters);
        model.air = {Vec3(0, 0, speed), Real(1.2)};
        start = make_rest_state(parameters);
    }

    /// How far it has been blown in the mean [m].
    [[nodiscard]] Real blown(IntegratorKind kind, Real time, Real step) const {
        const int steps = static_cast<int>(std::lround(time / step));
        return test::after({.integrator = kind}, model, start, time, steps).x.col(2).mean();
    }
};

TEST(Wind, HoldsASheetInTheSamePlaceByEveryMethodAtLongSteps) {
    const BlownFlag flag(Real(0.2), 2);
    constexpr Real time = 6;
    const Real exact = flag.blown(IntegratorKind::VelocityVerlet, time, Real(5e-4));
    EXPECT_GT(exact, 0.3);
    for (const IntegratorKind kind : unlimited_kinds) {
        for (const Real step : {Real(1) / 60, Real(1) / 30}) {
            EXPECT_NEAR(flag.blown(kind, time, step), exact, 0.05 * exact) << name_of(kind) << " at " << step;
        }
    }
}

TEST(Wind, ThatIsStrongThrowsALightSheetAboutByNoMethodWithinItsLimit) {
    const BlownFlag flag(Real(0.02), 20);
    const Real exact = flag.blown(IntegratorKind::VelocityVerlet, 1, Real(1e-4));
    EXPECT_GT(exact, 0.4);
    for (const IntegratorKind kind : unlimited_kinds) {
        const StepLimit limit = predicted_limit(flag.model, flag.start, kind, Kernels::Vector);
        EXPECT_EQ(std::isinf(limit.step), kind != IntegratorKind::ImplicitMidpoint);
        const Real step = std::min(Real(1) / 60, Real(0.9) * limit.step);
        // Ten rounds are few for so long a step of projective dynamics
        const Real part = kind == IntegratorKind::ProjectiveDynamics ? Real(0.1) : Real(0.05);
        EXPECT_NEAR(flag.blown(kind, 1, step), exact, part * exact) << name_of(kind);
    }
}

/// A sheet whose one free particle has six triangles about it and next to no springs.
TEST(Wind, IsInTheLimitOfEveryExplicitMethodHoweverTheClothIsTurned) {
    ClothParameters parameters;
    parameters.particles = {3, 3};
    parameters.pinned.kind = Pins::Kind::Border;
    parameters.structural = parameters.shear = parameters.bend = {Real(1e-6), 0};
    parameters.drag = 0;
    parameters.plane = Plane::XY;
    ClothModel model = make_cloth_model(parameters);
    const ClothState state = make_rest_state(parameters);
    const auto limit = [&](IntegratorKind kind) { return predicted_limit(model, state, kind, Kernels::Vector).step; };
    const Real calm = limit(IntegratorKind::SymplecticEuler);
    const Real area = Real(0.125), resists = 6 * plate_coefficient * Real(1.2) * 5 * area / 9;
    const Real d = resists / model.particle_mass;
    for (const Vec3& wind : {Vec3(0, 0, 5), Vec3(5, 0, 0)}) {
        model.air = {wind, Real(1.2)};
        EXPECT_NEAR(limit(IntegratorKind::SymplecticEuler) * d, 2, 0.01);
        EXPECT_NEAR(limit(IntegratorKind::VelocityVerlet) * d, 2, 0.01);
        EXPECT_NEAR(limit(IntegratorKind::Rk4) * d, 2.785, 0.01);
        EXPECT_LT(limit(IntegratorKind::SymplecticEuler), calm / 10);
    }
}

}  // namespace
}  // namespace drape
