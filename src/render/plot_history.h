#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <span>
#include <string>

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

inline constexpr std::size_t plot_curve_count = 11;
std::span<const PlotCurve, plot_curve_count> plot_curves();
std::span<const Plot, 5> plots();

/// The figures of the plots over the last ten seconds of wall time, as the scene's clock has them: ten seconds of scene
/// time, fewer in slow motion. A reset or another scene begins again.
class PlotHistory {
public:
    /// Moments that are kept at most.
    static constexpr std::size_t most = 300;

    /// Keeps the figures of a moment, unless it is the same as the last or too near to it to be told apart.
    void keep(const FrameView& view);

    /// How much time the plots show [s].
    [[nodiscard]] double span() const { return span_; }

    /// Moments that are kept.
    [[nodiscard]] std::size_t size() const { return moments_.size(); }

    /// The oldest moment that the plots show. @pre size() > 0
    [[nodiscard]] std::size_t oldest_shown() const;

    /// Of the k-th moment, from the oldest [s].
    [[nodiscard]] double time(std::size_t k) const { return moments_[k].time; }
    [[nodiscard]] float value(std::size_t k, std::size_t curve) const { return moments_[k].values[curve]; }

private:
    struct Moment {
        double time = 0;  ///< [s]
        std::array<float, plot_curve_count> values{};
    };

    std::deque<Moment> moments_;
    std::string scene_;
    double span_ = 10;
};

}  // namespace drape
