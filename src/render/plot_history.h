#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "drape/sim/frame_view.h"

namespace drape {

/// One curve of a plot.
struct PlotCurve {
    const char* label;
    double (*read)(const StepReport&);
};

/// Curves with one axis in common.
struct Plot {
    const char* title;  ///< with its unit
    std::size_t first, end;
    double scale;    ///< least height of the axis
    bool has_limit;  ///< 1 is marked
};

inline constexpr std::array plot_curves{
    PlotCurve{"integrate", [](const StepReport& r) { return 1e6 * r.times.step; }},
    PlotCurve{"BVH", [](const StepReport& r) { return 1e6 * (r.times.build + r.times.traverse); }},
    PlotCurve{"narrow", [](const StepReport& r) { return 1e6 * (r.times.narrow + r.times.pairs); }},
    PlotCurve{"response", [](const StepReport& r) { return 1e6 * r.times.respond; }},
    PlotCurve{"total", [](const StepReport& r) { return r.energy.total(); }},
    PlotCurve{"kinetic", [](const StepReport& r) { return r.energy.kinetic; }},
    PlotCurve{"candidates", [](const StepReport& r) { return static_cast<double>(r.traversal.candidates); }},
    PlotCurve{"contacts", [](const StepReport& r) { return static_cast<double>(r.contacts); }},
    PlotCurve{"all", [](const StepReport& r) { return static_cast<double>(r.traversal.nodes); }},
    PlotCurve{"tested", [](const StepReport& r) { return static_cast<double>(r.traversal.volume_tests); }},
    PlotCurve{"dt / limit", [](const StepReport& r) { return std::min(r.step_limit_ratio, 10.0); }},
};

inline constexpr std::array plots{
    Plot{"Time a step [us]", 0, 4, 1, false}, Plot{"Energy [J]", 4, 6, 1e-6, false}, Plot{"Contacts", 6, 8, 1, false},
    Plot{"Nodes", 8, 10, 1, false},           Plot{"Time step", 10, 11, 1.05, true},
};

/// The figures of the plots over the last ten seconds of wall time, as the scene's clock has them: ten seconds of scene
/// time, fewer in slow motion. A reset or another scene begins again.
class PlotHistory {
public:
    struct Moment {
        double time = 0;  ///< [s]
        std::array<float, plot_curves.size()> values{};
    };

    /// Moments that are kept at most.
    static constexpr std::size_t most = 300;

    /// Keeps the figures of a moment, unless it is the same as the last or too near to it to be told apart.
    void keep(const FrameView& view) {
        constexpr double history = 10;  // s of wall time
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

    /// How much time the plots show [s].
    [[nodiscard]] double span() const { return span_; }

    /// The moments that they show, from the oldest.
    [[nodiscard]] std::vector<Moment> shown() const {
        const auto is_shown = [this](const Moment& moment) { return moments_.back().time - moment.time <= span_; };
        return {std::ranges::find_if(moments_, is_shown), moments_.end()};
    }

private:
    std::deque<Moment> moments_;
    std::string scene_;
    double span_ = 10;
};

}  // namespace drape
