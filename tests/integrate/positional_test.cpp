// XPBD and projective dynamics.

#include <gtest/gtest.h>

#include <cmath>

#include "drape/integrate/integrator.h"
#include "drape/model/forces.h"
#include "integrate/damped_sheet.h"

namespace drape {
namespace {

using test::after;
using test::Sheet;

/// How far a step is from backward Euler's equations m (v' - v) = h f(x', v'), x' = x + h v', in parts of the largest
/// momentum gained.
Real imbalance(const ClothModel& model, const ClothState& before, const ClothState& now, Real h) {
    Points f(before.x.rows(), 3);
    compute_forces(model, now.x, now.v, f);
    f.array().colwise() *= model.inverse_mass;
    const Real of_v = (now.v - before.v - h * f).cwiseAbs().maxCoeff();
    const Real of_x = (now.x - before.x - h * now.v).cwiseAbs().maxCoeff() / h;
    return std::max(of_v, of_x) / (now.v - before.v).cwiseAbs().maxCoeff();
}

TEST(Xpbd, SolvesBackwardEulersEquationsWhenItsPassesSettleButForTheTurningOfSprings) {
    const Sheet sheet;
    const auto step = [&](int iterations, Real h) {
        const IntegratorParameters parameters{.integrator = IntegratorKind::Xpbd, .iterations = iterations};
        return imbalance(sheet.model, sheet.start, after(parameters, sheet.model, sheet.start, h, 1), h);
    };
    EXPECT_LT(step(300, 1e-2), 0.05);
    EXPECT_LT(step(300, 1e-3), 5e-3);
    EXPECT_LT(step(300, 1e-4), 5e-4);
    EXPECT_GT(step(1, 1e-2), 0.1);
}

TEST(ProjectiveDynamics, SolvesBackwardEulersEquationsOfUndampedSpringsWhenItsRoundsSettle) {
    Sheet sheet;
    sheet.undamp();
    sheet.model.drag = 0.01;
    constexpr Real h = 0.01;
    const auto step = [&](int iterations) {
        const IntegratorParameters parameters{.integrator = IntegratorKind::ProjectiveDynamics,
                                              .iterations = iterations};
        return imbalance(sheet.model, sheet.start, after(parameters, sheet.model, sheet.start, h, 1), h);
    };
    EXPECT_LT(step(300), 1e-12);
    EXPECT_GT(step(1), 1e-3);
}

TEST(PositionalMethods, StayWithinReachAtLongStepsAndStiffSprings) {
    Sheet sheet;
    for (const Real damping : {0., 5.}) {
        sheet.model.structural = sheet.model.shear = sheet.model.bend = {1e6, damping};
        for (const IntegratorKind kind : {IntegratorKind::Xpbd, IntegratorKind::ProjectiveDynamics}) {
            for (const int iterations : {1, 20}) {
                const ClothState now =
                    after({.integrator = kind, .iterations = iterations}, sheet.model, sheet.start, 20, 400);
                EXPECT_LT(now.x.cwiseAbs().maxCoeff(), 5) << name_of(kind) << ", " << iterations << ", " << damping;
            }
        }
    }
}

TEST(ProjectiveDynamics, StepsLikeNewAfterAnyChangeOfTheModel) {
    Sheet sheet;
    const auto used = make_integrator({.integrator = IntegratorKind::ProjectiveDynamics}, sheet.model.grid);
    const auto expect_like_new = [&](Real h, const char* change) {
        ClothState one = sheet.start, other = sheet.start;
        used->step(sheet.model, one, h);
        make_integrator({.integrator = IntegratorKind::ProjectiveDynamics}, sheet.model.grid)
            ->step(sheet.model, other, h);
        EXPECT_EQ(one.x, other.x) << change;
    };
    expect_like_new(0.01, "nothing");
    expect_like_new(0.02, "step");
    sheet.model.hold(7, true);
    expect_like_new(0.02, "pins");
    sheet.model.shear.stiffness = 500;
    expect_like_new(0.02, "stiffness");
    sheet.model.drag = 0.5;
    expect_like_new(0.02, "drag");
}

}  // namespace
}  // namespace drape
