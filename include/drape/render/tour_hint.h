#pragma once

#include <cstddef>
#include <vector>

#include "drape/render/renderer.h"

namespace drape {

/// What the hint panel says at a stop of the tour, counted from 0: what to see, what to try, what to read.
std::vector<KeyHelp> tour_hint(std::size_t stop);

}  // namespace drape
