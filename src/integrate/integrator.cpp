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
    const IntegratorKind kind = parameters.kind;
    if (kind == IntegratorKind::DormandPrince) return Real(1e-6);
    if (sizeof(Real) < 8) return Real(1e-4);
    if (parameters.hessian == Hessian::Exact) return Real(1e-8);
    return kind == IntegratorKind::ImplicitMidpoint ? Real(1e-6) : Real(1e-4);
}

Real displacement_factor(IntegratorKind kind) {
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
