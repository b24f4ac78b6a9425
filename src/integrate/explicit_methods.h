#pragma once

#include <memory>

#include "drape/integrate/integrator.h"

namespace drape {

/// Each is made in the file of its name; `grid` sizes its scratch arrays, `threads` share its work.
std::unique_ptr<Integrator> make_explicit_euler(const Grid& grid, int threads);
std::unique_ptr<Integrator> make_symplectic_euler(const Grid& grid, int threads);
std::unique_ptr<Integrator> make_velocity_verlet(const Grid& grid, int threads);
std::unique_ptr<Integrator> make_rk4(const Grid& grid, int threads);
std::unique_ptr<Integrator> make_dormand_prince(int particles, Real tolerance);

}  // namespace drape
