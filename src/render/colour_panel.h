#pragma once

#include "cloth_colours.h"
#include "figures_panel.h"

namespace drape {

/// The panel that says what the cloth's colours mean, at the lower right: a scale with numbers and a unit, or which
/// colour is what. Nothing where there is no room.
/// @param taken what is left of this belongs to others [pixel]
/// @param level whose nodes are shown
void colour_panel(const ColourScale& scale, int level, float taken, const OverlayPage& page);

}  // namespace drape
