#pragma once

#include "figures_panel.h"
#include "plot_history.h"

namespace drape {

/// A few figures over the last ten seconds, as curves in a strip at the bottom: time by stage, energy, contacts, nodes,
/// dt / limit.
class PlotsPanel {
public:
    static constexpr float columns = 52.5f, rows = 8;  ///< that it takes [font size]

    void keep(const FrameView& view) { history_.keep(view); }

    /// Makes the panel of a frame.
    /// @return the height that is taken at the bottom [pixel]
    float draw(const OverlayPage& page) const;

private:
    PlotHistory history_;
};

}  // namespace drape
