#include "render/step_medians.h"

#include <gtest/gtest.h>

namespace drape {
namespace {

class MedianSteps : public testing::Test {
protected:
    /// A step that took so long to integrate [s].
    void make_step(double time) {
        ++report_.step;
        report_.times.step = time;
        medians_.keep(report_);
    }

    [[nodiscard]] double shown() const { return medians_.with_median_times(report_).times.step; }

    StepReport report_;
    StepMedians medians_;
};

TEST_F(MedianSteps, ShowNoPauseOfTheMachineButStepsThatTakeLongerNow) {
    for (int k = 0; k < 100; ++k) make_step(1e-4);
    make_step(0.2);
    EXPECT_EQ(shown(), 1e-4);
    EXPECT_EQ(report_.times.step, 0.2) << "the report itself stays";
    report_.times.step = 1;
    for (int picture = 0; picture < 200; ++picture) medians_.keep(report_);
    EXPECT_EQ(shown(), 1e-4) << "a step counts once, however often it is drawn";
    for (std::size_t k = 0; k <= StepMedians::most / 2; ++k) make_step(3e-4);
    EXPECT_EQ(shown(), 3e-4);
    report_.step = 0;
    make_step(5e-4);
    EXPECT_EQ(shown(), 5e-4) << "another run";
}

}  // namespace
}  // namespace drape
