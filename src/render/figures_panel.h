#pragma once

#include <string>

#include "drape/render/renderer.h"
#include "panel_boxes.h"

namespace drape {

struct PanelFont;

/// Of the stats panel, where there is room [font size].
inline constexpr float figures_columns = 16.9f;

/// A time as it is best read: "812.3 us", "1.25 ms".
std::string time_text(double microseconds);

/// The stats panel at the top left: scene, integrator, time, stages, hierarchy, energy, cost; a few of these where it
/// is compact, and the energy balance while a ledger is kept. Rows that do not fit are left out, the least important
/// first.
/// @pre the panel is not off
/// @param last what the frame before this one cost
/// @return the panel's right edge [pixel]
float figures_panel(const FrameView& view, const FrameReport& last, const PanelFont& title, const OverlayPage& page);

}  // namespace drape
