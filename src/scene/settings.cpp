#include "drape/scene/settings.h"

#include <algorithm>
#include <tuple>

#include "drape/bounds/fold_test.h"
#include "drape/integrate/stability.h"

namespace drape {

Vec3 gravity_of(const Settings& settings) { return {0, -settings.world.gravity, 0}; }

IntegratorParameters integrator_of(const SolverSettings& solver) {
    return {.kind = solver.integrator,
            .hessian = solver.hessian,
            .iterations = solver.iterations,
            .tolerance = solver.tolerance,
            .newton_steps = solver.newton_steps,
            .threads = has_step_limit(solver.integrator) ? solver.threads : 1,
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

/// The settings that the motion follows from: what is left out shows or finds the same motion. Under a limited search
/// that is not so of the hierarchy, for then its nodes stand for the cloth.
Settings laws_of(Settings settings, bool limited) {
    if (settings.solver.on_unstable == OnUnstable::Stop) settings.solver.on_unstable = OnUnstable::Warn;
    settings.solver.ledger = {};
    settings.solver.threads = {};
    if (limited) return settings;
    const ContactSettings defaults;
    settings.contact.volume = defaults.volume;
    settings.contact.update = defaults.update;
    settings.contact.leaf_cells = defaults.leaf_cells;
    settings.contact.sphere_fit = defaults.sphere_fit;
    return settings;
}

}  // namespace

ResponseParameters response_of(const Settings& settings) {
    const ContactSettings& contact = settings.contact;
    return {.kind = contact.response,
            .friction = contact.friction,
            .pair_thickness = pair_thickness_of(settings),
            .stiffness = contact.stiffness,
            .displacement_factor = displacement_factor(settings.solver.integrator)};
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

bool same_motion(const Settings& a, const Settings& b) {
    const bool limited = !broad_phase_of(a).search.none() || !broad_phase_of(b).search.none();
    const Settings first = laws_of(a, limited), second = laws_of(b, limited);
    return first.cloths == second.cloths && first.balls == second.balls && first.solids == second.solids &&
           first.pins == second.pins && first.solver == second.solver && first.contact == second.contact &&
           first.ground == second.ground && first.world == second.world && first.wind == second.wind;
}

bool same_start(const Settings& a, const Settings& b) {
    const auto start_of = [](const ClothParameters& cloth) {
        return std::tuple(cloth.particles, cloth.width, cloth.height, cloth.plane, cloth.origin());
    };
    return a.start == b.start && std::ranges::equal(a.cloths, b.cloths, {}, start_of, start_of);
}

bool same_step_plan(const Settings& a, const Settings& b) {
    return a.cloths == b.cloths && a.solver.integrator == b.solver.integrator && a.solver.dt == b.solver.dt &&
           a.solver.on_unstable == b.solver.on_unstable && a.wind == b.wind;
}

}  // namespace drape
