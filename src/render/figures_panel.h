#pragma once

#include "drape/render/renderer.h"

struct ImFont;

namespace drape {

/// The picture as the panels see it, and the space around them and within [pixel].
struct OverlayPage {
    float width;
    float height;
    float margin;
};

/// The panel of figures at the top left: scene, method, time, stages, hierarchy, energy, cost. Rows that do not fit are
/// left out, the least important first.
/// @param last what the frame before this one cost
/// @return the panel's right edge [pixel]
float figures_panel(const FrameView& view, const FrameReport& last, ImFont* title, const OverlayPage& page);

}  // namespace drape
