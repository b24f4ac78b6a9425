#include "plot_history.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

constexpr double history = 10;  // s of wall time

constexpr double micro = 1e6;  // seconds are shown as microseconds

}  // namespace

std::span<const PlotCurve, plot_curve_count> plot_curves() {
    static constexpr std::array<PlotCurve, plot_curve_count> curves{{
        {"integrate", [](const StepReport& r) { return micro * r.times.step; }},
        {"BVH", [](const StepReport& r) { return micro * (r.times.build + r.times.traverse); }},
        {"narrow", [](const StepReport& r) { return micro * (r.times.narrow + r.times.pairs); }},
        {"response", [](const StepReport& r) { return micro * r.times.respond; }},
        {"total", [](const StepReport& r) { return r.energy.total(); }},
        {"kinetic", [](const StepReport& r) { return r.energy.kinetic; }},
        {"candidates", [](const StepReport& r) { return static_cast<double>(r.traversal.candidates); }},
        {"contacts", [](const StepReport& r) { return static_cast<double>(r.contacts); }},
        {"all", [](const StepReport& r) { return static_cast<double>(r.traversal.nodes); }},
        {"tested", [](const StepReport& r) { return static_cast<double>(r.traversal.volume_tests); }},
        {"dt / limit", [](const StepReport& r) { return std::min(r.step_limit_ratio, 10.0); }},
    }};
    return curves;
}

std::span<const Plot, 5> plots() {
    static constexpr std::array<Plot, 5> all{{
        {"Time a step [us]", 0, 4, 1, false},
        {"Energy [J]", 4, 6, 1e-6, false},
        {"Contacts", 6, 8, 1, false},
        {"Nodes", 8, 10, 1, false},
        {"Time step", 10, 11, 1.05, true},
    }};
    return all;
}

void PlotHistory::keep(const FrameView& view) {
    const StepReport& report = *view.report;
    span_ = history * view.settings->view.speed;
    if (view.scene != scene_ || (!moments_.empty() && report.time < moments_.back().time)) moments_.clear();
    scene_ = view.scene;
    if (!moments_.empty() && report.time < moments_.back().time + span_ / most) return;
    if (moments_.size() == most) moments_.pop_front();
    Moment& now = moments_.emplace_back();
    now.time = report.time;
    for (std::size_t c = 0; c < plot_curve_count; ++c) {
        const double value = plot_curves()[c].read(report);
        now.values[c] = std::isnan(value) ? 0 : static_cast<float>(std::clamp(value, -1e30, 1e30));
    }
}

std::size_t PlotHistory::oldest_shown() const {
    std::size_t oldest = 0;
    while (moments_.back().time - time(oldest) > span_) ++oldest;
    return oldest;
}

}  // namespace drape
