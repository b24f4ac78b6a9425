#pragma once

#include <array>
#include <cstddef>

#include "figures_panel.h"

namespace drape {

/// A few figures over the last ten seconds of scene time (fewer in slow motion), as curves in a strip at the bottom:
/// time by stage, energy, contacts, nodes, dt / limit. A reset begins again.
class PlotsPanel {
public:
    static constexpr float columns = 52.5f, rows = 8;  ///< that it takes [font size]

    /// Keeps the figures of a moment, unless it is the same as the last or too near to it to be told apart.
    void keep(const FrameView& view);

    /// Makes the panel of a frame.
    /// @return the height that is taken at the bottom [pixel]
    float draw(const OverlayPage& page) const;

    /// Moments that are kept.
    [[nodiscard]] std::size_t size() const { return count_; }

private:
    static constexpr std::size_t most = 300, curves = 11;
    struct Moment {
        double time = 0;  ///< [s]
        std::array<float, curves> values{};
    };

    /// The k-th, from the oldest.
    [[nodiscard]] const Moment& moment(std::size_t k) const { return moments_[(first_ + k) % most]; }

    std::array<Moment, most> moments_;
    std::size_t first_ = 0, count_ = 0;
    double span_ = 10;  ///< from the left edge to the right [s]
};

}  // namespace drape
