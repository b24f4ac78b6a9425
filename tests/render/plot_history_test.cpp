#include "render/plot_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace drape {
namespace {

/// A scene whose figures say when they were.
class PlottedScene : public testing::Test {
protected:
    PlottedScene() {
        view_.settings = &settings_;
        view_.report = &report_;
        view_.scene = "drop";
    }

    void keep(double time) {
        report_.time = time;
        report_.energy.kinetic = 100 + time;
        history_.keep(view_);
    }

    /// Frames at 60 Hz of scene time.
    void run(double from, double to, double frame = 1.0 / 60) {
        for (int k = 0; from + k * frame <= to; ++k) keep(from + k * frame);
    }

    static constexpr std::size_t kinetic = 5;
    Settings settings_;
    StepReport report_;
    FrameView view_;
    PlotHistory history_;
};

TEST_F(PlottedScene, ShowsTheLastTenSecondsAndForgetsWhatWasBefore) {
    run(0, 27);
    const std::vector<PlotHistory::Moment> shown = history_.shown();
    EXPECT_EQ(history_.span(), 10);
    EXPECT_GT(shown.back().time, 26.9);
    EXPECT_LE(shown.back().time - shown.front().time, 10);
    EXPECT_GT(shown.back().time - shown.front().time, 9.9) << "all ten of them";
    for (std::size_t k = 1; k < shown.size(); ++k) {
        EXPECT_LT(shown[k - 1].time, shown[k].time);
        EXPECT_LT(shown[k].time - shown[k - 1].time, 0.1) << "without a hole";
        EXPECT_FLOAT_EQ(shown[k].values[kinetic], static_cast<float>(100 + shown[k].time));
    }
}

TEST_F(PlottedScene, KeepsNoMoreThanItMay) {
    run(0, 27);
    settings_.view.speed = 100;
    keep(27 + 1000.0 / PlotHistory::most);
    EXPECT_EQ(history_.span(), 1000) << "longer than what it was kept for";
    EXPECT_EQ(history_.shown().size(), PlotHistory::most);
}

TEST_F(PlottedScene, BeginsAgainAfterAResetAndInAnotherScene) {
    run(0, 3);
    keep(0);
    keep(0.001);  // could not be told apart
    ASSERT_EQ(history_.shown().size(), 1u);
    run(0.1, 1);
    EXPECT_EQ(history_.shown().front().time, 0);
    view_.scene = "curtain";  // whose clock may be later
    report_.step_limit_ratio = std::numeric_limits<double>::infinity();
    report_.energy.spring = std::nan("");
    keep(5);
    const std::vector<PlotHistory::Moment> shown = history_.shown();
    ASSERT_EQ(shown.size(), 1u);
    EXPECT_EQ(shown[0].time, 5);
    for (std::size_t c = 0; c < plot_curves.size(); ++c) EXPECT_TRUE(std::isfinite(shown[0].values[c])) << c;
}

TEST_F(PlottedScene, CoversTenSecondsOfTheWallInSlowMotion) {
    settings_.view.speed = 0.01;
    run(0, 0.3, 0.01 / 60);
    EXPECT_DOUBLE_EQ(history_.span(), 0.1);
    const double shown = history_.shown().back().time - history_.shown().front().time;
    EXPECT_LE(shown, 0.1);
    EXPECT_GT(shown, 0.099);
    settings_.view.speed = 1;
    run(0.31, 1);
    EXPECT_EQ(history_.span(), 10);
    EXPECT_LT(history_.shown().front().time, 0.3) << "what was kept in slow motion is still there";
}

TEST(Plots, HaveEachCurveOnce) {
    std::size_t next = 0;
    for (const Plot& plot : plots) {
        EXPECT_EQ(plot.first, next) << plot.title;
        next = plot.end;
    }
    EXPECT_EQ(next, plot_curves.size());
    StepReport report;
    report.times = {.step = 1e-6, .build = 2e-6, .traverse = 3e-6, .narrow = 4e-6, .pairs = 5e-6, .respond = 6e-6};
    report.energy = {.kinetic = 7, .gravity = 8, .spring = 9};
    report.traversal = {.nodes = 10, .volume_tests = 11, .candidates = 12};
    report.contacts = 13;
    report.step_limit_ratio = 0.5;
    const double expected[] = {1, 5, 9, 6, 24, 7, 12, 13, 10, 11, 0.5};
    for (std::size_t c = 0; c < plot_curves.size(); ++c) {
        EXPECT_DOUBLE_EQ(plot_curves[c].read(report), expected[c]) << plot_curves[c].label;
    }
}

}  // namespace
}  // namespace drape
