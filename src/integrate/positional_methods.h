#pragma once

#include <memory>

#include "drape/integrate/integrator.h"

namespace drape {

/// Each is made in the file of its name; `grid` sizes its scratch arrays.
std::unique_ptr<Integrator> make_xpbd(const Grid& grid, int iterations);
std::unique_ptr<Integrator> make_projective_dynamics(const Grid& grid, int iterations);

}  // namespace drape
