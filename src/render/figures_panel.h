#pragma once

#include "drape/render/renderer.h"

struct ImFont;

namespace drape {

/// The panel of figures at the top left: scene, method, time, stages, hierarchy, energy, cost. Rows that do not fit are
/// left out, the least important first.
/// @param last what the frame before this one cost
/// @param width, height of the picture [pixel]
/// @return the panel's right edge [pixel]
float figures_panel(const FrameView& view, const FrameReport& last, ImFont* title, float width, float height);

}  // namespace drape
