#pragma once

#include <memory>

#include "drape/integrate/integrator.h"

namespace drape {

/// Each is made in the file of its name, and solves one linear system a step: see `NewtonSystem`.
std::unique_ptr<Integrator> make_backward_euler(const Grid& grid, Hessian hessian);
std::unique_ptr<Integrator> make_implicit_midpoint(const Grid& grid, Hessian hessian);
std::unique_ptr<Integrator> make_bdf2(const Grid& grid, Hessian hessian);

}  // namespace drape
