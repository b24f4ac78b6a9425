#include "drape/integrate/integrator.h"

#include <array>

#include "methods.h"

namespace drape {

const MethodRow& method_of(IntegratorKind kind) {
    // In the order of the kinds
    static constexpr std::array<MethodRow, 10> rows{{
        {.make = make_euler, .longest_step = longest_step_of_explicit_euler, .numbers = 3},
        {.make = make_euler, .longest_step = longest_step_of_symplectic_euler, .numbers = 3},
        {.make = make_velocity_verlet,
         .longest_step = longest_step_of_velocity_verlet,
         .displacement = 0.5,
         .numbers = 9},
        {.make = make_rk4, .longest_step = longest_step_of_rk4, .displacement = 0.5, .numbers = 15},
        {.make = make_theta_method, .tolerance = 1e-4, .numbers = 18, .keeps = Keeps::NewtonSystem},
        {.make = make_theta_method,
         .displacement = 0.5,
         .tolerance = 1e-6,
         .numbers = 18,
         .keeps = Keeps::NewtonSystem},
        {.make = make_bdf2, .tolerance = 1e-4, .numbers = 33, .keeps = Keeps::NewtonSystem},
        {.make = make_xpbd, .numbers = 15, .iterates = true},
        {.make = make_projective_dynamics, .numbers = 30, .keeps = Keeps::ScalarFactors, .iterates = true},
        {.make = make_dormand_prince, .displacement = 0.5, .tolerance = 1e-6, .numbers = 57},
    }};
    static_assert(rows.size() == enum_count<IntegratorKind>, "every kind has its row");
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
