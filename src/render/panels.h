#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "cloth_colours.h"
#include "drape/render/renderer.h"
#include "panel_boxes.h"
#include "plot_history.h"

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

/// What the plots take [font size].
inline constexpr float plots_columns = 52.5f, plots_rows = 8;

/// A few figures over the last ten seconds, as curves in a strip at the bottom: time by stage, energy, contacts, nodes,
/// dt / limit.
/// @return the height that is taken at the bottom [pixel]
float plots_panel(const PlotHistory& history, const OverlayPage& page);

/// Whether there is anything to show in the bar of time: the run stands still, or is in its past, or is a replay.
bool is_timeline_due(const FrameView& view);

/// Where it is, at the bottom of a page.
PanelBox timeline_place(const OverlayPage& page);

/// The bar of time, with Dear ImGui's widgets: where the run stands between the oldest step that is kept and the
/// newest, or in the recording that is replayed.
/// @return the step that a drag on it asks for
std::optional<std::int64_t> timeline_panel(const Timeline& timeline, const PanelBox& box);

/// Begins a panel at the lower right, with its title.
/// @param size of it, its margins included [pixel]
/// @param taken what is left of this belongs to others [pixel]
/// @return where its lines begin; nothing where there is no room
std::optional<ImVec2> begin_legend(const std::string& title, ImVec2 size, float taken, const OverlayPage& page);

/// The panel that says what the cloth's colours mean, at the lower right: a scale with numbers and a unit, or which
/// colour is what. Nothing where there is no room.
/// @param taken what is left of this belongs to others [pixel]
/// @param level whose nodes are shown
void colour_panel(const ColourScale& scale, int level, float taken, const OverlayPage& page);

/// Likewise for arrows at contacts, and for strains of cells.
/// @param title with what a line of full length stands for
/// @return the height that is taken at the bottom [pixel]
float line_panel(const std::string& title, std::span<const LineLook> looks, float taken, const OverlayPage& page);

}  // namespace drape
