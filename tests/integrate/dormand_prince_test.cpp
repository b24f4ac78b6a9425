#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drape/integrate/integrator.h"
#include "integrate/damped_sheet.h"

namespace drape {
namespace {

using test::after;
using test::Sheet;

IntegratorParameters with_tolerance(Real tolerance) {
    return {.integrator = IntegratorKind::DormandPrince, .tolerance = tolerance};
}

TEST(DormandPrince, IsFiveToleratedErrorsFromTheTruthAtMost) {
    // Six steps of many inner ones each
    const Sheet sheet;
    constexpr Real horizon = 0.1;
    const Real spacing = std::min(sheet.model.hx, sheet.model.hy);
    const ClothState exact = after({.integrator = IntegratorKind::Rk4}, sheet.model, sheet.start, horizon, 20000);
    Real last = std::numeric_limits<Real>::infinity();
    for (const Real tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
        const ClothState now = after(with_tolerance(tolerance), sheet.model, sheet.start, horizon, 6);
        const Real error = (now.x - exact.x).cwiseAbs().maxCoeff() / spacing;
        EXPECT_LT(error, 5 * tolerance);
        EXPECT_LT(error, last / 4) << tolerance;
        last = error;
    }
}

TEST(DormandPrince, TakesAsManyInnerStepsAsItsToleranceAsks) {
    const Sheet sheet;
    const auto steps = [&](Real tolerance, Real h) {
        ClothState state = sheet.start;
        const auto integrator = make_integrator(with_tolerance(tolerance), sheet.model.grid);
        const SolveReport report = integrator->step(sheet.model, state, h);
        EXPECT_GE(report.force_evaluations, 1 + 6 * report.iterations);
        EXPECT_EQ(report.force_evaluations % 6, 1);
        return report.iterations;
    };
    EXPECT_EQ(steps(1e-6, 1e-4), 1);
    // The error estimate grows with the fifth power of the inner step: a hundred thousandth asks for ten times the
    // steps
    const double ratio = static_cast<double>(steps(1e-11, 0.1)) / steps(1e-6, 0.1);
    EXPECT_GT(ratio, 7);
    EXPECT_LT(ratio, 13);
}

TEST(DormandPrince, ReportsItsLargestErrorAndWhereItIsAboveTheTolerance) {
    const Sheet sheet;
    const auto report_of = [&](Real tolerance, ClothState state) {
        return make_integrator(with_tolerance(tolerance), sheet.model.grid)->step(sheet.model, state, 0.01);
    };
    const SolveReport good = report_of(1e-6, sheet.start);
    EXPECT_EQ(good.unconverged, 0);
    EXPECT_FALSE(good.gave_up);
    EXPECT_GT(good.residual, 0);
    EXPECT_LE(good.residual, 1e-6);
    EXPECT_EQ(good.tolerance, Real(1e-6));
    // A tolerance below rounding, and a state that no number can hold: it ends all the same
    const SolveReport bad = report_of(1e-30, sheet.start);
    EXPECT_LE(bad.iterations, max_inner_steps + 1);
    EXPECT_EQ(bad.unconverged, bad.iterations);
    EXPECT_GT(bad.residual, 1e-30);
    ClothState fast = sheet.start;
    fast.v(7, 1) = std::numeric_limits<Real>::max();
    EXPECT_EQ(report_of(1e-6, fast).unconverged, 1);
    EXPECT_FALSE(after(with_tolerance(1e-6), sheet.model, fast, 0.01, 1).x.allFinite());
}

/// However rounding divides a step: one of the shortest parts is taken, not tried again for ever.
TEST(LongDormandPrince, TakesItsShortestStepsWhateverTheStep) {
    Sheet sheet;
    const auto integrator = make_integrator(with_tolerance(1e-30), sheet.model.grid);
    for (int k = 0; k < 12; ++k) {
        ClothState state = sheet.start;
        const SolveReport report = integrator->step(sheet.model, state, Real(1e-4) + Real(1e-6) * std::sqrt(Real(k)));
        EXPECT_GT(report.iterations, max_inner_steps - 10) << k;
        EXPECT_LE((report.force_evaluations - 1) / 6, max_inner_steps) << k;
    }
}

}  // namespace
}  // namespace drape
