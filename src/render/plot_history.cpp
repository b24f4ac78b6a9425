#include "plot_history.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

constexpr double history = 10;  // s of wall time

}  // namespace

void PlotHistory::keep(const FrameView& view) {
    const StepReport& report = *view.report;
    span_ = history * view.settings->view.speed;
    if (view.scene != scene_ || (!moments_.empty() && report.time < moments_.back().time)) moments_.clear();
    scene_ = view.scene;
    if (!moments_.empty() && report.time < moments_.back().time + span_ / most) return;
    if (moments_.size() == most) moments_.pop_front();
    Moment& now = moments_.emplace_back();
    now.time = report.time;
    for (std::size_t c = 0; c < plot_curves.size(); ++c) {
        const double value = plot_curves[c].read(report);
        now.values[c] = std::isnan(value) ? 0 : static_cast<float>(std::clamp(value, -1e30, 1e30));
    }
}

std::size_t PlotHistory::oldest_shown() const {
    std::size_t oldest = 0;
    while (moments_.back().time - time(oldest) > span_) ++oldest;
    return oldest;
}

}  // namespace drape
