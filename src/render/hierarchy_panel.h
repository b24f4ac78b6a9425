#pragma once

#include <vector>

#include "figures_panel.h"
#include "node_states.h"

namespace drape {

/// The panel that explains drawn bounding volumes, at the lower right: which level of which volume, what the last
/// query did level by level, and what the colours say.
class HierarchyPanel {
public:
    /// Nothing where there is no room.
    /// @param taken what is left of this belongs to others [pixel]
    /// @return how high it is, with a margin [pixel]
    float draw(const FrameView& view, float taken, const OverlayPage& page);

private:
    void count(const FrameView& view, int levels);

    std::vector<LevelCounts> counts_;
    std::vector<NodeView> nodes_;
    TouchedCells touched_;
};

}  // namespace drape
