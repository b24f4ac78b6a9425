#pragma once

#include <memory>

#include "drape/integrate/integrator.h"

namespace drape {

/// Each is made in the file of its name; `particles` sizes its scratch arrays.
std::unique_ptr<Integrator> make_explicit_euler(int particles);
std::unique_ptr<Integrator> make_symplectic_euler(int particles);
std::unique_ptr<Integrator> make_velocity_verlet(int particles);
std::unique_ptr<Integrator> make_rk4(int particles);
std::unique_ptr<Integrator> make_dormand_prince(int particles, Real tolerance);

}  // namespace drape
