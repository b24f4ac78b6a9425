#pragma once

#include "drape/integrate/integrator.h"

namespace drape {

/// Each is made with scratch arrays for a grid; where a function makes two kinds, the parameters say which.

std::unique_ptr<Integrator> make_euler(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_velocity_verlet(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_rk4(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_theta_method(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_bdf2(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_xpbd(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_projective_dynamics(const IntegratorParameters& parameters, const Grid& grid);
std::unique_ptr<Integrator> make_dormand_prince(const IntegratorParameters& parameters, const Grid& grid);

}  // namespace drape
