#include "drape/integrate/integrator.h"

#include <array>

#include "drape/base/assert.h"
#include "explicit_methods.h"
#include "implicit_methods.h"
#include "positional_methods.h"

namespace drape {

std::unique_ptr<Integrator> make_integrator(const IntegratorParameters& parameters, const Grid& grid) {
    const int threads = parameters.threads;
    switch (parameters.kind) {
        case IntegratorKind::ExplicitEuler:
            return make_explicit_euler(grid, threads);
        case IntegratorKind::SymplecticEuler:
            return make_symplectic_euler(grid, threads);
        case IntegratorKind::VelocityVerlet:
            return make_velocity_verlet(grid, threads);
        case IntegratorKind::Rk4:
            return make_rk4(grid, threads);
        case IntegratorKind::BackwardEuler:
            return make_backward_euler(grid, parameters.hessian);
        case IntegratorKind::ImplicitMidpoint:
            return make_implicit_midpoint(grid, parameters.hessian);
        case IntegratorKind::Bdf2:
            return make_bdf2(grid, parameters.hessian);
        case IntegratorKind::Xpbd:
            return make_xpbd(grid, parameters.iterations);
        case IntegratorKind::ProjectiveDynamics:
            return make_projective_dynamics(grid, parameters.iterations);
        case IntegratorKind::DormandPrince:
            return make_dormand_prince(grid.particles(), parameters.tolerance);
    }
    DRAPE_ASSERT(false && "every kind has its method");
    return nullptr;
}

}  // namespace drape
