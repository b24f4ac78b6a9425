#pragma once

#include "drape/integrate/integrator.h"

namespace drape {

/// About what an integrator takes at most, in making and stepping, for one cloth [bytes]. The arrays are counted; the
/// fill-in of factors is fitted to square grids from 8 to 420 a side.
double bytes_of_method(const IntegratorParameters& parameters, const Grid& grid);

}  // namespace drape
