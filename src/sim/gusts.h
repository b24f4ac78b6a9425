#pragma once

#include "drape/model/cloth_model.h"
#include "drape/sim/settings.h"

namespace drape {

/// The air at a time: the mean wind with two gusts of incommensurate frequency on it. It depends on time alone.
Air air_at(const WindSettings& wind, double time);

/// The fastest that it can get.
Air strongest_air(const WindSettings& wind);

}  // namespace drape
