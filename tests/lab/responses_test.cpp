#include <gmock/gmock.h>

#include <cmath>

#include "lab/lab_run.h"
#include "lab/responses/responses.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using testing::HasSubstr;

constexpr ResponseKind every_response[] = {ResponseKind::Projection, ResponseKind::Penalty, ResponseKind::Impulse,
                                           ResponseKind::Hybrid};

TEST(LabBounce, ConvergesUnderProjection) {
    const Row coarse = drop_sheet(ResponseKind::Projection, Real(1) / 240);
    const Row fine = drop_sheet(ResponseKind::Projection, Real(1) / 15360);
    EXPECT_LT(fine.number("height_error"), 0.002);
    EXPECT_LT(fine.number("height_error"), coarse.number("height_error") / 4);
    EXPECT_LT(fine.number("impact_error_s"), 1e-4);
    // A push that is carried over is taken back once nothing needs it
    EXPECT_LT(drop_sheet(ResponseKind::Projection, Real(1) / 60).number("height_error"), 0.1);
}

/// Impulses take the time and the speed of the impact within the step. What is left is the slop.
TEST(LabBounce, HasTheSameSmallErrorAtAnyStepUnderImpulses) {
    for (const ResponseKind kind : {ResponseKind::Impulse, ResponseKind::Hybrid}) {
        for (const int rate : {60, 240, 15360}) {
            const Row bounce = drop_sheet(kind, 1 / static_cast<Real>(rate));
            EXPECT_LT(bounce.number("height_error"), 2e-4) << name_of(kind) << ", 1/" << rate << " s";
            EXPECT_LT(bounce.number("impact_error_s"), 5e-5) << name_of(kind) << ", 1/" << rate << " s";
        }
    }
}

/// The planted fault: at a penalty's depth the sheet turns back later than on hard ground.
TEST(LabBounce, ComesLateFromAPenaltyByHalfASwing) {
    const double mass = 0.2 / 36, stiffness = 1000;
    const Row bounce = drop_sheet(ResponseKind::Penalty, Real(1) / 15360);
    EXPECT_NEAR(bounce.number("impact_error_s"), std::acos(-1) * std::sqrt(mass / stiffness), 2e-4);
}

TEST(LabSlope, HoldsTheSheetAtEveryStepButBeyondTheLimitOfAPenalty) {
    for (const ResponseKind kind : every_response) {
        EXPECT_LT(lay_on_slope(kind, Real(1) / 960).number("drift_m_per_s"), 1e-6) << name_of(kind);
        const double drift = lay_on_slope(kind, Real(1) / 60).number("drift_m_per_s");
        const bool is_hard = kind == ResponseKind::Projection || kind == ResponseKind::Impulse;
        EXPECT_EQ(drift < 1e-6, is_hard) << name_of(kind) << ": " << drift << " m/s";
    }
}

TEST(LabPenaltyLimit, FallsWithTheRootOfTheStiffnessAndIsNearThePrediction) {
    const Row soft = find_penalty_limit(100, Real(0.5)), stiff = find_penalty_limit(10000, Real(0.5));
    EXPECT_NEAR(soft.number("measured_step_s") / stiff.number("measured_step_s"), 10, 0.3);
    EXPECT_NEAR(soft.number("predicted_step_s") / stiff.number("predicted_step_s"), 10, 1e-3);
    EXPECT_NEAR(soft.number("measured_step_s") / soft.number("predicted_step_s"), 1, 0.1);
}

TEST(LabPenaltyLimit, IsLongerWhereDampersSeeWhatHasMoved) {
    const Row bounces = find_penalty_limit(1000, Real(0.5), IntegratorKind::VelocityVerlet);
    EXPECT_NEAR(bounces.number("measured_step_s") / bounces.number("predicted_step_s"), 1, 0.05);
    const Row stops = find_penalty_limit(1000, 0, IntegratorKind::VelocityVerlet);
    EXPECT_NEAR(stops.number("measured_step_s") / stops.number("predicted_step_s"), 1.1, 0.05);
    EXPECT_GT(stops.number("measured_step_s"), 1.3 * find_penalty_limit(1000, 0).number("measured_step_s"));
}

TEST(LabResponses, WritesARowAStepAndARowALimit) {
    const LabFolder folder;
    const LabRun run = folder.run({"responses", "--quick", "--cases", "16-17", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto rows = table_of(folder, "out/responses.csv");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_THAT(rows[1], HasSubstr("16,step,hybrid,0.00026042,"));
    EXPECT_THAT(rows[2], HasSubstr("17,limit,penalty,nan,"));
}

}  // namespace
}  // namespace drape
