#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "combination.h"
#include "drape/base/input_error.h"
#include "drape/contact/detection.h"
#include "drape/integrate/stability.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "lab/experiments.h"

namespace drape {
namespace {

/// Short enough for the method, and for a penalty's own limit.
double step_of(IntegratorKind integrator, ResponseKind response) {
    if (integrator == IntegratorKind::ExplicitEuler) return 2e-4;
    if (response == ResponseKind::Penalty) return 2.5e-4;
    return has_step_limit(integrator) ? 5e-4 : 2.5e-3;
}

/// The same by every volume with every update, brute force left out.
std::vector<Settings> with_all_trees(const Settings& combination) {
    std::vector<Settings> all;
    for (const VolumeKind volume : values_of<VolumeKind>()) {
        if (volume == VolumeKind::Brute) continue;
        for (const UpdateKind update : values_of<UpdateKind>()) {
            Settings& settings = all.emplace_back(combination);
            settings.contact.volume = volume;
            settings.contact.update = update;
        }
    }
    return all;
}

/// A combination, by brute force and by trees.
Rows run_trees(IntegratorKind integrator, ResponseKind response, const std::string& detection, bool quick) {
    constexpr double seconds = 2;
    const Settings combination = combination_of(integrator, response, detection == "continuous");
    auto [hash, row] = run_combination(combination, seconds);
    const auto trees = quick ? std::vector{with_sampled_tree(combination)} : with_all_trees(combination);
    for (const Settings& tree : trees) {
        if (run_combination(tree, seconds).hash == hash) continue;
        throw RunError(fmt::format("combinations: {}, {}, {}: {}, {} gives other bits than brute force",
                                   name_of(integrator), name_of(response), detection, name_of(tree.contact.volume),
                                   name_of(tree.contact.update)));
    }
    row.set("trees", trees.size());
    return {row};
}

}  // namespace

Settings combination_of(IntegratorKind integrator, ResponseKind response, bool continuous) {
    Settings settings = load_scene("drop");
    settings.cloths[0].particles = {10, 10};
    settings.cloths[0].structural = {200, Real(0.05)};  // damped enough for explicit Euler
    settings.solver.integrator = integrator;
    settings.solver.dt = step_of(integrator, response);
    settings.contact.self = false;
    settings.contact.response = response;
    settings.contact.continuous = continuous ? Continuous::Always : Continuous::Never;
    settings.contact.volume = VolumeKind::Brute;
    settings.contact.update = UpdateKind::Rebuild;
    settings.contact.leaf_cells = 2;
    return settings;
}

Settings with_sampled_tree(const Settings& combination) {
    constexpr std::size_t updates = enum_count<UpdateKind>, volumes = enum_count<VolumeKind> - 1;
    // Both numbers go through all their values for one integrator, and from one integrator to the next
    const ContactSettings& contact = combination.contact;
    const auto integrator = static_cast<std::size_t>(combination.solver.integrator);
    const std::size_t rest =
        2 * static_cast<std::size_t>(contact.response) + (contact.continuous == Continuous::Always);
    return with_all_trees(combination)[(integrator + rest) % volumes * updates + (3 * integrator + rest) % updates];
}

CombinationRun run_combination(const Settings& combination, double seconds) {
    Simulation simulation("drop", combination);
    const Cloth& cloth = simulation.cloths()[0];
    const ClothModel& model = cloth.model;
    const auto weight = static_cast<double>(model.particle_mass * model.gravity.norm()) * model.grid.particles();
    const StepReport& report = simulation.report();
    const Real thickness = combination.contact.thickness;
    Real penetration = 0;
    int touched = 0;
    double min_lift = std::numeric_limits<double>::infinity(), energy_gain = 0;
    while (report.status != Status::Diverged && report.time < seconds) {
        simulation.step();
        const Real sunk = combination.ground.height + thickness - cloth.state.x.col(1).minCoeff();
        const Real deep = deepest_penetration(model.grid, cloth.state.x, simulation.balls(), thickness);
        penetration = std::max({penetration, deep, sunk});
        touched += report.contacts > 0;
        const Energy energy = simulation.view().report->energy;
        const double lift = (energy.kinetic + energy.gravity + energy.spring) / weight;
        min_lift = std::min(min_lift, lift);
        energy_gain = std::max(energy_gain, lift - min_lift);
    }
    constexpr double max_gain = 0.05, max_speed = 0.45;  // m, m/s
    const char* flaw = report.status == Status::Diverged  ? "diverged"
                       : touched == 0                     ? "no_contact"
                       : !(penetration <= thickness)      ? "penetration"
                       : !(energy_gain <= max_gain)       ? "energy"
                       : !(report.rms_speed <= max_speed) ? "speed"
                                                          : "none";
    return {simulation.hash(),
            {{"step_s", combination.solver.dt},
             {"touched_steps", touched},
             {"penetration_m", penetration},
             {"energy_gain_m", energy_gain},
             {"speed_m_per_s", report.rms_speed},
             {"flaw", flaw}}};
}

Experiment combinations_experiment() {
    return {"combinations",
            "does every integrator work with every response, volume and update?",
            4,
            {"integrator", "response", "detection",
             "trees",  // with the same bits as brute force
             "step_s", "touched_steps",
             "penetration_m",  // largest, of any triangle in the ball or particle in the ground
             "energy_gain_m",  // largest rise above the least so far: the height by which it would lift
             "speed_m_per_s",  // RMS at the end
             "flaw"},
            {{"",
              cases_over(run_trees, Axis<IntegratorKind>{"integrator", values_of<IntegratorKind>()},
                         Axis<ResponseKind>{"response", values_of<ResponseKind>()},
                         Axis<std::string>{"detection", {"discrete", "continuous"}}, quick_or_whole(true, false)),
              {}}}};
}

}  // namespace drape
