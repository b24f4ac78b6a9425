#include "drape/integrate/integrator.h"

#include <array>

#include "methods.h"

namespace drape {

std::unique_ptr<Integrator> make_integrator(const IntegratorParameters& parameters, const Grid& grid) {
    // In the order of the kinds
    constexpr std::array makers{
        make_euler, make_euler, make_velocity_verlet,     make_rk4,           make_theta_method, make_theta_method,
        make_bdf2,  make_xpbd,  make_projective_dynamics, make_dormand_prince};
    static_assert(makers.size() == enum_names<IntegratorKind>.size(), "every kind has its method");
    return makers[static_cast<std::size_t>(parameters.kind)](parameters, grid);
}

Real tolerance_of(const IntegratorParameters& parameters) {
    if (parameters.tolerance > 0) return parameters.tolerance;
    const auto of_a_solve = [&](double clamped) {
        if (sizeof(Real) < 8) return Real(1e-4);
        return static_cast<Real>(parameters.hessian == Hessian::Exact ? 1e-8 : clamped);
    };
    switch (parameters.kind) {
        case IntegratorKind::BackwardEuler:
        case IntegratorKind::Bdf2:
            return of_a_solve(1e-4);
        case IntegratorKind::ImplicitMidpoint:
            return of_a_solve(1e-6);
        case IntegratorKind::DormandPrince:
            return Real(1e-6);
        case IntegratorKind::ExplicitEuler:
        case IntegratorKind::SymplecticEuler:
        case IntegratorKind::VelocityVerlet:
        case IntegratorKind::Rk4:
        case IntegratorKind::Xpbd:
        case IntegratorKind::ProjectiveDynamics:
            break;
    }
    return of_a_solve(1e-4);
}

Real displacement_factor(IntegratorKind kind) {
    switch (kind) {
        case IntegratorKind::VelocityVerlet:
        case IntegratorKind::Rk4:
        case IntegratorKind::ImplicitMidpoint:
        case IntegratorKind::DormandPrince:
            return Real(0.5);
        case IntegratorKind::ExplicitEuler:
        case IntegratorKind::SymplecticEuler:
        case IntegratorKind::BackwardEuler:
        case IntegratorKind::Bdf2:
        case IntegratorKind::Xpbd:
        case IntegratorKind::ProjectiveDynamics:
            break;
    }
    return 1;
}

}  // namespace drape
