#pragma once

#include <algorithm>
#include <optional>

#include "picture_pace.h"

namespace drape {

/// The wall time that a scene gets: none before its first picture is shown, and small parts in its first second, so
/// that a slow display shows slowly how it begins.
class SceneClock {
public:
    /// A picture was shown. @return whether it is the first
    bool begin() {
        if (shown_for_) return false;
        shown_for_ = 0;
        return true;
    }

    /// @param elapsed since the last tick [s]
    /// @return what the scene gets of it [s]
    double pass(double elapsed) {
        if (!shown_for_) return 0;
        const double passed = *shown_for_ < opening ? std::min(elapsed, PicturePace::longest) : elapsed;
        *shown_for_ += passed;
        return passed;
    }

    static constexpr double opening = 1;  ///< of which nothing is left out [s]

private:
    std::optional<double> shown_for_;  ///< [s]
};

}  // namespace drape
