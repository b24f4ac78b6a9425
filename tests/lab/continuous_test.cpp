#include <gmock/gmock.h>

#include <cmath>

#include "lab/continuous/shots.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using testing::HasSubstr;

/// How far a share of so many shots may be from its mean: four standard deviations.
double chance(double share, double shots) { return 4 * std::sqrt(share * (1 - share) / shots) + 1e-3; }

TEST(LongContinuousShots, AreMissedByWholeStepsAsPredictedAndNeverByWhatIsBetween) {
    for (const Target target : {Target::Point, Target::Sheet}) {
        for (const double q : {0.3, 0.7, 1.0, 1.5, 4.0}) {
            const ShotCount count = shoot(target, q, 5000);
            const double expected = predicted_misses(target, q);
            EXPECT_NEAR(count.discrete / count.shots, expected, chance(expected, count.shots)) << q;
            EXPECT_EQ(count.continuous, 0) << q;
            if (target != Target::Point || q != 1.5) continue;
            // The prediction of a chord that is always as long as the ball is wide
            const double wrong = predicted_misses(Target::Sheet, q);
            EXPECT_GT(std::abs(count.discrete / count.shots - wrong), chance(wrong, count.shots));
        }
    }
}

TEST(LabContinuous, TellsMissesAndTimes) {
    const LabFolder folder;
    const LabRun run = folder.run({"continuous", "--quick", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto rows = table_of(folder, "out/continuous.csv");
    ASSERT_EQ(rows.size(), 13u) << "a header, four speeds at two targets, and two cloths by two detections";
    EXPECT_THAT(run.out, HasSubstr("misses, point, none, q 0.5: 1 row, discrete_missed 0.08"));
    EXPECT_THAT(run.out, HasSubstr("time, none, continuous, particles 1024: 1 row, build_s "));
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(folder.read("out/continuous_misses.svg"), HasSubstr("</svg>"));
    EXPECT_THAT(folder.read("out/continuous_time.svg"), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace drape
