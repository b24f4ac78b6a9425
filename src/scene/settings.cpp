#include "drape/scene/settings.h"

#include <algorithm>

#include "drape/bounds/fold_test.h"

namespace drape {

Vec3 gravity_of(const Settings& settings) { return {0, -settings.world.gravity, 0}; }

IntegratorParameters integrator_of(const SolverSettings& solver) {
    return {.kind = solver.integrator,
            .hessian = solver.hessian,
            .iterations = solver.iterations,
            .tolerance = solver.tolerance,
            .newton_steps = solver.newton_steps,
            .threads = solver.threads,
            .kernels = solver.kernels};
}

namespace {

/// Cloth keeps away from cloth by the thickness, but never by so much that a flat one would push itself apart: by half
/// of what features that share no particle are apart at rest.
Real pair_thickness_of(const Settings& settings) {
    Real thickness = settings.contact.thickness;
    for (const ClothParameters& cloth : settings.cloths) {
        const Real hx = cloth.width / static_cast<Real>(cloth.particles.nx - 1);
        const Real hy = cloth.height / static_cast<Real>(cloth.particles.ny - 1);
        thickness = std::min(thickness, apart_at_rest(hx, hy) / 2);
    }
    return thickness;
}

}  // namespace

ResponseParameters response_of(const Settings& settings) {
    const ContactSettings& contact = settings.contact;
    return {.kind = contact.response,
            .friction = contact.friction,
            .pair_thickness = pair_thickness_of(settings),
            .stiffness = contact.stiffness,
            .displacement_factor = displacement_factor(settings.solver.integrator),
            .kernels = settings.solver.kernels};
}

BroadPhaseParameters broad_phase_of(const Settings& settings) {
    const ContactSettings& contact = settings.contact;
    return {.volume = contact.volume,
            .update = contact.update,
            .leaf_cells = contact.leaf_cells,
            .sphere_fit = contact.sphere_fit,
            .search = {.level = contact.search_level, .tests = contact.search_tests},
            .kernels = settings.solver.kernels};
}

}  // namespace drape
