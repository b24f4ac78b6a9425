#pragma once

#include "cloth_colours.h"
#include "figures_panel.h"

namespace drape {

/// The panel that says what the cloth's colours mean, at the bottom: a scale with numbers and a unit, or which colour
/// is what.
/// @param right the panel's right edge [pixel]
/// @param level whose nodes are shown
/// @return its left edge [pixel]
float colour_panel(const ColourScale& scale, int level, float right, const OverlayPage& page);

}  // namespace drape
