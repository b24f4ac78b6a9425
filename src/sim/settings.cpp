#include "drape/sim/settings.h"

namespace drape {

IntegratorParameters integrator_of(const SolverSettings& solver) {
    return {.kind = solver.integrator,
            .hessian = solver.hessian,
            .iterations = solver.iterations,
            .tolerance = solver.tolerance,
            .threads = solver.threads,
            .kernels = solver.kernels};
}

ResponseParameters response_of(const Settings& settings) {
    const ContactSettings& contact = settings.contact;
    return {.kind = contact.response,
            .friction = contact.friction,
            .restitution = contact.restitution,
            .thickness = contact.thickness,
            .stiffness = contact.stiffness,
            .ground = settings.ground,
            .integrator = settings.solver.integrator};
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
