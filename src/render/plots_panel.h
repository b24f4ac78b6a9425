#pragma once

#include "figures_panel.h"
#include "plot_history.h"

namespace drape {

/// What the plots take [font size].
inline constexpr float plots_columns = 52.5f, plots_rows = 8;

/// A few figures over the last ten seconds, as curves in a strip at the bottom: time by stage, energy, contacts, nodes,
/// dt / limit.
/// @return the height that is taken at the bottom [pixel]
float plots_panel(const PlotHistory& history, const OverlayPage& page);

}  // namespace drape
