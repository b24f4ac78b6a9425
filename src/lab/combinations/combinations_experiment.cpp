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

/// A combination, by brute force and by trees.
Rows run_trees(const Settings& combination, const std::vector<Settings>& trees) {
    constexpr double seconds = 2;
    auto [hash, row] = run_combination(combination, seconds);
    for (const Settings& tree : trees) {
        if (run_combination(tree, seconds).hash == hash) continue;
        throw RunError(fmt::format("combinations: {}, {}, {}: {}, {} gives other bits than brute force",
                                   row.word("integrator"), row.word("response"), row.word("detection"),
                                   name_of(tree.contact.volume), name_of(tree.contact.update)));
    }
    row.set("trees", trees.size());
    return {row};
}

ExperimentCases combination_cases(bool quick) {
    ExperimentCases all;
    for (const Settings& combination : all_combinations()) {
        const std::size_t number = all.size();
        all.push_back([=] {
            const auto trees = with_all_trees(combination);
            return run_trees(combination, quick ? std::vector{trees[sampled_tree(number)]} : trees);
        });
    }
    return all;
}

}  // namespace

std::vector<Settings> all_combinations() {
    Settings settings = load_scene("drop");
    settings.cloths[0].particles = {10, 10};
    settings.cloths[0].structural = {200, Real(0.05)};  // damped enough for explicit Euler
    settings.contact.self = false;
    settings.contact.volume = VolumeKind::Brute;
    settings.contact.update = UpdateKind::Rebuild;
    settings.contact.leaf_cells = 2;
    std::vector<Settings> all;
    for (const IntegratorKind integrator : values_of<IntegratorKind>()) {
        for (const ResponseKind response : values_of<ResponseKind>()) {
            for (const Continuous continuous : {Continuous::Never, Continuous::Always}) {
                settings.solver.integrator = integrator;
                settings.solver.dt = step_of(integrator, response);
                settings.contact.response = response;
                settings.contact.continuous = continuous;
                all.push_back(settings);
            }
        }
    }
    return all;
}

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

std::size_t sampled_tree(std::size_t number) {
    constexpr std::size_t updates = enum_count<UpdateKind>, volumes = enum_count<VolumeKind> - 1;
    // Both numbers go through all their values for one integrator, and from one integrator to the next
    const std::size_t integrator = number / 8, rest = number % 8;
    return (integrator + rest) % volumes * updates + (3 * integrator + rest) % updates;
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
    const bool continuous = combination.contact.continuous == Continuous::Always;
    return {simulation.hash(),
            {{"integrator", combination.solver.integrator},
             {"response", combination.contact.response},
             {"detection", continuous ? "continuous" : "discrete"},
             {"step_s", combination.solver.dt},
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
            {{"", combination_cases, {}}}};
}

}  // namespace drape
