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

/// The stats panel at the top left: scene, integrator, time, stages, hierarchy, energy, cost; a few of these where it
/// is compact. Rows that do not fit are left out, the least important first.
/// @pre the panel is not off
/// @param last what the frame before this one cost
/// @return the panel's right edge [pixel]
float figures_panel(const FrameView& view, const FrameReport& last, ImFont* title, const OverlayPage& page);

}  // namespace drape
