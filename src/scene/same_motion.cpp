#include "drape/scene/same_motion.h"

#include <algorithm>

#include "drape/integrate/stability.h"

namespace drape {
namespace {

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

bool same_start(const ClothParameters& a, const ClothParameters& b) {
    return a.particles == b.particles && a.width == b.width && a.height == b.height && a.plane == b.plane &&
           a.origin() == b.origin();
}

}  // namespace

bool same_motion(const Settings& a, const Settings& b) {
    const bool limited = !broad_phase_of(a).search.none() || !broad_phase_of(b).search.none();
    const Settings first = laws_of(a, limited), second = laws_of(b, limited);
    return first.cloths == second.cloths && first.balls == second.balls && first.solids == second.solids &&
           first.pins == second.pins && first.solver == second.solver && first.contact == second.contact &&
           first.ground == second.ground && first.world == second.world && first.wind == second.wind;
}

bool same_start(const Settings& a, const Settings& b) {
    return a.start == b.start && std::ranges::equal(a.cloths, b.cloths, [](const auto& one, const auto& other) {
               return same_start(one, other);
           });
}

bool same_integrator(const SolverSettings& a, const SolverSettings& b) {
    IntegratorParameters first = integrator_of(a);
    const IntegratorParameters second = integrator_of(b);
    if (!has_step_limit(second.kind)) first.threads = second.threads;
    return first == second;
}

bool same_step_plan(const Settings& a, const Settings& b) {
    return a.cloths == b.cloths && a.solver.integrator == b.solver.integrator && a.solver.dt == b.solver.dt &&
           a.solver.on_unstable == b.solver.on_unstable && a.wind == b.wind;
}

}  // namespace drape
