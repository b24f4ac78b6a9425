#include "drape/integrate/integrator.h"

#include <array>

#include "drape/base/assert.h"
#include "explicit_methods.h"

namespace drape {

std::unique_ptr<Integrator> make_integrator(IntegratorKind kind, int particles) {
    switch (kind) {
        case IntegratorKind::ExplicitEuler:
            return make_explicit_euler(particles);
        case IntegratorKind::SymplecticEuler:
            return make_symplectic_euler(particles);
        case IntegratorKind::VelocityVerlet:
            return make_velocity_verlet(particles);
        case IntegratorKind::Rk4:
            return make_rk4(particles);
    }
    DRAPE_ASSERT(false && "every kind has its method");
    return nullptr;
}

std::span<const std::string> integrator_names() {
    static const std::array<std::string, 4> names{"explicit_euler", "symplectic_euler", "velocity_verlet", "rk4"};
    return names;
}

std::string_view name_of(IntegratorKind kind) { return integrator_names()[static_cast<std::size_t>(kind)]; }

}  // namespace drape
