#include "drape/integrate/integrator.h"

#include <array>

#include "methods.h"

namespace drape {

const MethodRow& method_of(IntegratorKind kind) {
    using enum Keeps;
    // In the order of the kinds
    static constexpr std::array<MethodRow, 10> rows{{
        {make_euler, longest_step_of_explicit_euler, 1, 0, 3, Nothing, false},
        {make_euler, longest_step_of_symplectic_euler, 1, 0, 3, Nothing, false},
        {make_velocity_verlet, longest_step_of_velocity_verlet, 0.5, 0, 9, Nothing, false},
        {make_rk4, longest_step_of_rk4, 0.5, 0, 15, Nothing, false},
        {make_theta_method, nullptr, 1, 1e-4, 12, NewtonSystem, false},
        {make_theta_method, nullptr, 0.5, 1e-6, 12, NewtonSystem, false},
        {make_bdf2, nullptr, 1, 1e-4, 30, NewtonSystem, false},
        {make_xpbd, nullptr, 1, 0, 15, Nothing, true},
        {make_projective_dynamics, nullptr, 1, 0, 30, ScalarFactors, true},
        {make_dormand_prince, nullptr, 0.5, 1e-6, 57, Nothing, false},
    }};
    static_assert(rows.size() == enum_names<IntegratorKind>.size(), "every kind has its row");
    static_assert(rows.back().make != nullptr, "and no row is left empty");
    return rows[static_cast<std::size_t>(kind)];
}

std::unique_ptr<Integrator> make_integrator(const IntegratorParameters& parameters, const Grid& grid) {
    return method_of(parameters.kind).make(parameters, grid);
}

Real tolerance_of(const IntegratorParameters& parameters) {
    if (parameters.tolerance > 0) return parameters.tolerance;
    const MethodRow& method = method_of(parameters.kind);
    if (method.keeps != Keeps::NewtonSystem) return static_cast<Real>(method.tolerance);
    if (sizeof(Real) < 8) return Real(1e-4);
    return static_cast<Real>(parameters.hessian == Hessian::Exact ? 1e-8 : method.tolerance);
}

Real displacement_factor(IntegratorKind kind) { return static_cast<Real>(method_of(kind).displacement); }

bool has_iterations(IntegratorKind kind) { return method_of(kind).iterates; }

bool solves_a_system(IntegratorKind kind) { return method_of(kind).keeps == Keeps::NewtonSystem; }

}  // namespace drape
