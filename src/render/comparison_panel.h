#pragma once

#include <cstddef>
#include <deque>

#include "drape/session/comparison.h"
#include "panel_boxes.h"
#include "step_medians.h"

namespace drape {

/// The figures of both simulations of a comparison beside each other at the upper right, and how far apart they are,
/// with its curve over the last seconds.
class ComparisonPanel {
public:
    /// Keeps how far they are apart.
    void keep(const FrameView& view);

    /// Makes the panel of a frame. @pre there is a comparison
    /// @param left, right edges of the room for it; without room it is left out [pixel]
    /// @return its left edge, or `right` [pixel]
    float draw(const FrameView& view, const OverlayPage& page, float left, float right) const;

private:
    static constexpr std::size_t most = 240;
    StepMedians other_medians_;
    std::deque<double> distances_;  ///< root mean squares over the particles, from the oldest to now [m]
    double time_ = 0;               ///< of the last one [s]
};

}  // namespace drape
