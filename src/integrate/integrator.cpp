#include "drape/integrate/integrator.h"

#include <array>

#include "drape/base/assert.h"
#include "methods.h"

namespace drape {

std::unique_ptr<Integrator> make_integrator(const IntegratorParameters& parameters, const Grid& grid) {
    switch (parameters.kind) {
        case IntegratorKind::ExplicitEuler:
            return make_explicit_euler(parameters, grid);
        case IntegratorKind::SymplecticEuler:
            return make_symplectic_euler(parameters, grid);
        case IntegratorKind::VelocityVerlet:
            return make_velocity_verlet(parameters, grid);
        case IntegratorKind::Rk4:
            return make_rk4(parameters, grid);
        case IntegratorKind::BackwardEuler:
            return make_backward_euler(parameters, grid);
        case IntegratorKind::ImplicitMidpoint:
            return make_implicit_midpoint(parameters, grid);
        case IntegratorKind::Bdf2:
            return make_bdf2(parameters, grid);
        case IntegratorKind::Xpbd:
            return make_xpbd(parameters, grid);
        case IntegratorKind::ProjectiveDynamics:
            return make_projective_dynamics(parameters, grid);
        case IntegratorKind::DormandPrince:
            return make_dormand_prince(parameters, grid);
    }
    DRAPE_ASSERT(false && "every kind has its method");
    return nullptr;
}

Real displacement_share(IntegratorKind kind) {
    switch (kind) {
        case IntegratorKind::VelocityVerlet:
        case IntegratorKind::Rk4:
        case IntegratorKind::ImplicitMidpoint:
        case IntegratorKind::DormandPrince:
            return Real(0.5);
        default:
            return 1;
    }
}

}  // namespace drape
