#include "drape/integrate/integrator.h"

#include <array>

#include "drape/base/assert.h"
#include "explicit_methods.h"

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
        default:
            break;
    }
    DRAPE_ASSERT(false && "every kind has its method");
    return nullptr;
}

std::span<const std::string> integrator_names() {
    static const std::array<std::string, 10> names{"explicit_euler",
                                                   "symplectic_euler",
                                                   "velocity_verlet",
                                                   "rk4",
                                                   "backward_euler",
                                                   "implicit_midpoint",
                                                   "bdf2",
                                                   "xpbd",
                                                   "projective_dynamics",
                                                   "dormand_prince"};
    return names;
}

std::span<const std::string> hessian_names() {
    static const std::array<std::string, 2> names{"clamped", "exact"};
    return names;
}

std::string_view name_of(IntegratorKind kind) { return integrator_names()[static_cast<std::size_t>(kind)]; }

}  // namespace drape
