#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cloth_colours.h"
#include "drape/render/renderer.h"
#include "drape/session/comparison.h"
#include "drawn_nodes.h"
#include "overlay_style.h"
#include "plot_history.h"
#include "step_medians.h"

namespace drape {

/// Of the stats panel, where there is room [font size].
inline constexpr float figures_columns = 16.9f;

/// The stats panel at the top left: scene, integrator, time, stages, hierarchy, energy, cost; a few of these where it
/// is compact, and the energy balance while a ledger is kept. Rows that do not fit are left out, the least important
/// first.
/// @pre the panel is not off
/// @param last what the frame before this one cost
/// @param pointer under which a row says what it means [pixel]
/// @return where it is
PanelBox figures_panel(const FrameView& view, const FrameReport& last, const PanelFont& title, const OverlayPage& page,
                       ImVec2 pointer);

/// What the plots take [font size].
inline constexpr float plots_columns = 52.5f, plots_rows = 8;

/// A few figures over the last ten seconds, as curves in a strip at the bottom: time by stage, energy, contacts, nodes,
/// dt / limit.
/// @return the height that is taken at the bottom [pixel]
float plots_panel(const PlotHistory& history, const OverlayPage& page);

/// The bar of time at the bottom, with Dear ImGui's widgets: where the run stands between the oldest step that is kept
/// and the newest, or in the recording that is replayed. Nothing unless the run stands still, or is in its past, or is
/// a replay.
/// @param wanted receives how long before the newest step a drag on it asks for [s]
/// @return where it is
PanelBox timeline_panel(const FrameView& view, const OverlayPage& page, std::optional<double>& wanted);

/// The panel that says what the cloth's colours mean, at the lower right: a scale with numbers and a unit, or which
/// colour is what. Nothing where there is no room.
/// @param taken what is left of this belongs to others [pixel]
/// @param level whose nodes are shown
void colour_panel(const ColourScale& scale, int level, float taken, const OverlayPage& page);

/// Likewise for arrows at contacts, and for strains of cells.
/// @param title with what a line of full length stands for
/// @return the height that is taken at the bottom [pixel]
float line_panel(const std::string& title, std::span<const LineLook> looks, float taken, const OverlayPage& page);

/// The panel that explains drawn bounding volumes, likewise: which level of which volume, what the last query did level
/// by level, how tight they are, and what the colours say.
/// @param fits of the frames before
/// @return as of `line_panel`
float hierarchy_panel(const FrameView& view, LevelFits& fits, float taken, const OverlayPage& page);

/// Names the node under the pointer beside it, if there is one.
/// @param x, y of the pointer [pixel]
void node_panel(const FrameView& view, const Camera& camera, int x, int y, const OverlayPage& page);

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

private:
    static constexpr std::size_t most = 240;
    StepMedians other_medians_;
    std::deque<double> distances_;  ///< root mean squares over the particles, from the oldest to now [m]
    double time_ = 0;               ///< of the last one [s]
};

/// The keys at the upper right, in the largest font in which all are seen.
/// @param fonts up to the usual one, from the smallest
/// @param beside whether the stats panel is to have room beside it, in that font
/// @return whether it has
bool help_panel(std::span<const KeyHelp> lines, std::span<const PanelFont> fonts, const OverlayPage& page, bool beside);

/// That a hint is wide at least, if its text is [font size].
inline constexpr float hint_columns = 24;

/// What to try first, at the bottom beside the other panels, in a smaller font where there is no room.
/// @param fonts as of `help_panel`
void hint_panel(std::span<const KeyHelp> lines, std::span<const PanelFont> fonts, const OverlayPage& page,
                const std::vector<PanelBox>& others);

}  // namespace drape
