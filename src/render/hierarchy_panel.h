#pragma once

#include <vector>

#include "node_pick.h"
#include "node_states.h"
#include "panel_boxes.h"
#include "tightness.h"

namespace drape {

/// The panel that explains drawn bounding volumes, at the lower right: which level of which volume, what the last
/// query did level by level, how tight they are, and what the colours say. Beside the pointer it names the node there.
class HierarchyPanel {
public:
    /// Nothing where there is no room.
    /// @param taken what is left of this belongs to others [pixel]
    /// @return how high it is, with a margin [pixel]
    float draw(const FrameView& view, float taken, const OverlayPage& page);

    /// Names the node under the pointer, if there is one.
    /// @param x, y of the pointer [pixel]
    void name_node(const FrameView& view, const Camera& camera, int x, int y, const OverlayPage& page);

private:
    void count(const FrameView& view, int levels);

    std::vector<LevelCounts> counts_;
    std::vector<NodeView> nodes_;
    TouchedCells touched_;
    LevelFits fits_;
    NodePicker picker_;
};

}  // namespace drape
