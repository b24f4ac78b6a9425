#include <gtest/gtest.h>

#include <cmath>

#include "lab/experiments.h"

namespace drape {
namespace {

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

}  // namespace
}  // namespace drape
