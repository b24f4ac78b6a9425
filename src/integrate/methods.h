#pragma once

#include "drape/integrate/integrator.h"

namespace drape {

/// Each is made with scratch arrays for a grid.

std::unique_ptr<Integrator> make_explicit_euler(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_symplectic_euler(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_velocity_verlet(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_rk4(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_backward_euler(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_implicit_midpoint(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_bdf2(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_xpbd(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_projective_dynamics(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_dormand_prince(const IntegratorParameters& parameters, const Grid& grid);

}  // namespace drape
