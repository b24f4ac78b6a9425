#include <gtest/gtest.h>

#include "lab/experiments.h"

namespace drape {
namespace {

TEST(LabSolve, LeavesLessToACloserToleranceAndFarLessThanTheStep) {
    const Rows rows = solve_experiment().cases(true)[0]();
    ASSERT_EQ(rows.size(), 7u);
    double before = 1;
    for (const Row& row : rows) {
        const double tolerance = row.number("tolerance"), left = row.number("solver_error_m");
        EXPECT_LT(left, before / 2) << tolerance;
        if (tolerance <= 1e-4) {
            EXPECT_LT(left, row.number("step_error_m") / 200) << tolerance;
        }
        before = left;
    }
}

/// Small sheets are moved in real time by an explicit method, and are near the converged one; five passes of XPBD a
/// frame leave the springs too long.
TEST(LabRealtime, SaysWhichClothsAreInTimeAndWhichAreStretched) {
    const ExperimentCases cases = realtime_experiment().cases(true);
    const Rows in_time = cases[0](), stretched = cases[9]();
    ASSERT_EQ(in_time.size(), 3u);
    for (const Row& row : in_time) {
        EXPECT_EQ(row.word("method"), "symplectic_euler_by_1");
        EXPECT_EQ(row.word("end"), "realtime") << row.word("side");
        EXPECT_LT(row.number("error"), 0.02) << row.word("side");
    }
    for (const Row& row : stretched) {
        EXPECT_EQ(row.word("method"), "xpbd_1_by_5");
        EXPECT_EQ(row.word("end"), "stretched") << row.word("side");
    }
}

}  // namespace
}  // namespace drape
