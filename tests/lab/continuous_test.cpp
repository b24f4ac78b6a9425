#include <gmock/gmock.h>

#include <cmath>

#include "lab/experiments.h"
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
    const ExperimentCases cases = continuous_experiment().cases(true);
    for (std::size_t k = 0; k < 8; ++k) {
        const Row row = cases[k]().front();
        const double predicted = row.number("predicted");
        EXPECT_NEAR(row.number("discrete_missed"), predicted, chance(predicted, row.number("shots")))
            << row.word("target") << ", q = " << row.number("q");
        EXPECT_EQ(row.number("continuous_missed"), 0) << row.word("target") << ", q = " << row.number("q");
    }
}

TEST(LabContinuous, TellsMissesAndTimes) {
    const LabFolder folder;
    const LabRun run = folder.run({"continuous", "--quick", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto rows = table_of(folder, "out/continuous.csv");
    ASSERT_EQ(rows.size(), 13u) << "a header, four speeds at two targets, and two cloths by two detections";
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(folder.read("out/continuous_misses.svg"), HasSubstr("</svg>"));
    EXPECT_THAT(folder.read("out/continuous_time.svg"), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace drape
