#pragma once

#include <array>
#include <cstddef>

#include "drape/sim/comparison.h"
#include "figures_panel.h"
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

    /// How far apart they were, root mean square over the particles, from the oldest to now [m].
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] double kept(std::size_t k) const { return distances_[(first_ + k) % most]; }

private:
    static constexpr std::size_t most = 240;
    StepMedians other_medians_;
    std::array<double, most> distances_{};
    std::size_t first_ = 0, count_ = 0;
    double time_ = 0;  ///< of the last one [s]
};

}  // namespace drape
