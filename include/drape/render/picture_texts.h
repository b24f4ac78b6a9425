#pragma once

#include <vector>

#include "drape/render/image.h"
#include "drape/sim/simulation.h"

namespace drape {

/// What a picture of a simulation says of how to make it again: program, commit, scene, time and settings.
std::vector<ImageText> picture_texts(const Simulation& simulation);

}  // namespace drape
