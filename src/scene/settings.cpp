#include "drape/scene/settings.h"

#include <algorithm>
#include <tuple>

#include "drape/bounds/fold_test.h"

namespace drape {

Vec3 gravity_of(const Settings& settings) { return {0, -settings.world.gravity, 0}; }

namespace {

/// Cloth keeps away from cloth by the thickness, but never by so much that a flat one would push itself apart: by half
/// of what features that share no particle are apart at rest.
Real pair_thickness_of(const Settings& settings) {
    Real thickness = settings.contact.thickness;
    for (const ClothParameters& cloth : settings.cloths) {
        thickness = std::min(thickness, apart_at_rest(cloth.hx(), cloth.hy()) / 2);
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
            .displacement_factor = displacement_factor(settings.solver.integrator)};
}

BroadPhaseParameters broad_phase_of(const Settings& settings) {
    BroadPhaseParameters parameters = settings.contact;
    parameters.kernels = settings.solver.kernels;
    return parameters;
}

bool same_motion(const Settings& a, const Settings& b) {
    return a.cloths == b.cloths && a.balls == b.balls && a.solids == b.solids && a.pins == b.pins &&
           a.solver == b.solver && a.contact == b.contact && a.ground == b.ground && a.world == b.world &&
           a.wind == b.wind;
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
