#include <gtest/gtest.h>

#include <cmath>

#include "drape/contact/response.h"
#include "lab/experiments.h"

namespace drape {
namespace {

/// What the experiment finds of a response at a step of 1/60 s, a quarter, a 16th or a 64th of that.
Row at_step(ResponseKind kind, std::size_t quarterings) {
    return responses_experiment().cases(true)[4 * static_cast<std::size_t>(kind) + quarterings]().front();
}

TEST(LabBounce, ConvergesUnderProjection) {
    const Row coarse = at_step(ResponseKind::Projection, 1), fine = at_step(ResponseKind::Projection, 3);
    EXPECT_LT(fine.number("height_error"), 0.002);
    EXPECT_LT(fine.number("height_error"), coarse.number("height_error") / 4);
    EXPECT_LT(fine.number("impact_error_s"), coarse.number("impact_error_s") / 4);
    // A push that is carried over is taken back once nothing needs it
    EXPECT_LT(at_step(ResponseKind::Projection, 0).number("height_error"), 0.1);
}

/// Impulses take the time and the speed of the impact within the step. What is left is the slop.
TEST(LabBounce, HasTheSameSmallErrorAtAnyStepUnderImpulses) {
    for (const ResponseKind kind : {ResponseKind::Impulse, ResponseKind::Hybrid}) {
        for (const std::size_t quarterings : {0u, 1u, 3u}) {
            const Row bounce = at_step(kind, quarterings);
            EXPECT_LT(bounce.number("height_error"), 2e-4) << name_of(kind) << ", " << bounce.number("step_s") << " s";
            EXPECT_LT(bounce.number("impact_error_s"), 5e-5) << name_of(kind);
        }
    }
}

/// The planted fault: at a penalty's depth the sheet turns back later than on hard ground.
TEST(LabBounce, ComesLateFromAPenaltyByHalfASwing) {
    const double mass = 0.2 / 36, stiffness = 1000;
    const Row bounce = at_step(ResponseKind::Penalty, 3);
    EXPECT_NEAR(bounce.number("impact_error_s"), std::acos(-1) * std::sqrt(mass / stiffness), 2e-4);
}

TEST(LabSlope, HoldsTheSheetAtEveryStepButBeyondTheLimitOfAPenalty) {
    for (const ResponseKind kind : values_of<ResponseKind>()) {
        EXPECT_LT(at_step(kind, 2).number("drift_m_per_s"), 1e-6) << name_of(kind);
        const double drift = at_step(kind, 0).number("drift_m_per_s");
        const bool is_hard = kind == ResponseKind::Projection || kind == ResponseKind::Impulse;
        EXPECT_EQ(drift < 1e-6, is_hard) << name_of(kind) << ": " << drift << " m/s";
    }
}

TEST(LabPenaltyLimit, FallsWithTheRootOfTheStiffnessAndIsNearThePrediction) {
    const ExperimentCases cases = responses_experiment().cases(true);
    const Row soft = cases[17]().front(), stiff = cases[20]().front();  // 100 N/m and 1000 N/m, of the restitution 1/2
    EXPECT_NEAR(soft.number("measured_step_s") / stiff.number("measured_step_s"), std::sqrt(10), 0.1);
    EXPECT_NEAR(soft.number("predicted_step_s") / stiff.number("predicted_step_s"), std::sqrt(10), 1e-3);
    EXPECT_NEAR(soft.number("measured_step_s") / soft.number("predicted_step_s"), 1, 0.1);
}

}  // namespace
}  // namespace drape
