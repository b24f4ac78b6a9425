#include "drape/integrate/integrator.h"

#include <array>
#include <bit>

#include "bdf2.h"
#include "dormand_prince.h"
#include "explicit_methods.h"
#include "projective_dynamics.h"
#include "step_limits.h"
#include "theta_method.h"
#include "xpbd.h"

namespace drape {
namespace {

template <class Method>
std::unique_ptr<Integrator> make(const IntegratorParameters& parameters, const Grid& grid) {
    return std::make_unique<Method>(parameters, grid);
}

}  // namespace

const MethodRow& method_of(IntegratorKind kind) {
    // In the order of the kinds
    static constexpr std::array<MethodRow, 10> rows{{
        {.make = make<Euler>, .longest_step = longest_step_of_explicit_euler, .numbers = 3},
        {.make = make<Euler>, .longest_step = longest_step_of_symplectic_euler, .numbers = 3},
        {.make = make<VelocityVerlet>,
         .longest_step = longest_step_of_velocity_verlet,
         .displacement = 0.5,
         .numbers = 9},
        {.make = make<Rk4>, .longest_step = longest_step_of_rk4, .displacement = 0.5, .numbers = 15},
        {.make = make<ThetaMethod>, .tolerance = 1e-4, .numbers = 18, .keeps = Keeps::NewtonSystem},
        {.make = make<ThetaMethod>,
         .displacement = 0.5,
         .tolerance = 1e-6,
         .numbers = 18,
         .keeps = Keeps::NewtonSystem},
        {.make = make<Bdf2>, .tolerance = 1e-4, .numbers = 33, .keeps = Keeps::NewtonSystem},
        {.make = make<Xpbd>, .numbers = 15, .iterates = true},
        {.make = make<ProjectiveDynamics>, .numbers = 30, .keeps = Keeps::ScalarFactors, .iterates = true},
        {.make = make<DormandPrince>, .displacement = 0.5, .tolerance = 1e-6, .numbers = 57},
    }};
    static_assert(rows.size() == enum_count<IntegratorKind>, "every kind has its row");
    static_assert(rows.back().numbers > 0, "and no row is left empty");
    return rows[static_cast<std::size_t>(kind)];
}

std::unique_ptr<Integrator> make_integrator(const IntegratorParameters& parameters, const Grid& grid) {
    return method_of(parameters.integrator).make(parameters, grid);
}

double bytes_of_method(const IntegratorParameters& parameters, const Grid& grid) {
    const MethodRow& method = method_of(parameters.integrator);
    // Factors of a square grid have O(n log n) entries
    const double log_n = std::bit_width(static_cast<unsigned>(grid.particles()));
    double of_particle = sizeof(Real) * method.numbers;
    if (method.keeps == Keeps::ScalarFactors) of_particle += 150 * log_n;
    // The rows of multigrid are made long for vectors
    if (method.keeps == Keeps::NewtonSystem) of_particle += 1000 + 20'000.0 / grid.nx;
    if (method.keeps == Keeps::NewtonSystem && NewtonSystem::keeps_factors(grid, parameters.hessian)) {
        of_particle += 600 * log_n;
    }
    return of_particle * grid.particles();
}

Real tolerance_of(const IntegratorParameters& parameters) {
    if (parameters.tolerance > 0) return parameters.tolerance;
    const MethodRow& method = method_of(parameters.integrator);
    if (method.keeps != Keeps::NewtonSystem) return static_cast<Real>(method.tolerance);
    if (sizeof(Real) < 8) return Real(1e-4);
    return static_cast<Real>(parameters.hessian == Hessian::Exact ? 1e-8 : method.tolerance);
}

Real displacement_factor(IntegratorKind kind) { return static_cast<Real>(method_of(kind).displacement); }

}  // namespace drape
