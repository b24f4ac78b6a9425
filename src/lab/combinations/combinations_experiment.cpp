#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "combination.h"
#include "drape/base/input_error.h"
#include "drape/contact/search_audit.h"
#include "drape/integrate/stability.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "lab/experiments.h"
#include "lab/measure/methods.h"

namespace drape {
namespace {

/// What a run may have: the thickness of the cloth of `drop` [m], a height [m], a speed [m/s].
constexpr double most_penetration = 0.002, most_energy_gain = 0.05, most_speed = 0.45;

/// Short enough for the method, and for a penalty's own limit.
double step_of(const Combination& combination) {
    if (combination.integrator == IntegratorKind::ExplicitEuler) return 2e-4;
    if (combination.response == ResponseKind::Penalty) return 2.5e-4;
    return has_step_limit(combination.integrator) ? 5e-4 : 2.5e-3;
}

Settings combined_settings(const Combination& combination, const SearchTree& tree,
                           const std::vector<std::string>& changes) {
    Settings settings = load_scene("drop");
    ClothParameters& cloth = settings.cloths[0];
    cloth.particles = {10, 10};
    cloth.structural = {200, Real(0.05)};  // damped enough for explicit Euler
    settings.solver.integrator = combination.integrator;
    settings.solver.dt = step_of(combination);
    settings.contact.response = combination.response;
    settings.contact.self = false;
    settings.contact.continuous = combination.continuous ? Continuous::Always : Continuous::Never;
    settings.contact.volume = tree.volume;
    settings.contact.update = tree.update;
    settings.contact.leaf_cells = 2;
    assign_all(settings, changes);
    return settings;
}

/// Measures a run after its steps.
class CombinationWatch {
public:
    explicit CombinationWatch(const Simulation& simulation)
        : audit_(simulation.cloths()[0].model.grid, simulation.settings().solver.kernels) {}

    void look(Simulation& simulation, CombinationRun& run) {
        const Cloth& cloth = simulation.cloths()[0];
        const ClothModel& model = cloth.model;
        const Settings& settings = simulation.settings();
        const Real depth = audit_.penetration(cloth.state.x, simulation.balls(), settings.contact.thickness);
        const Real sunk = settings.ground.height + settings.contact.thickness - cloth.state.x.col(1).minCoeff();
        run.penetration = std::max(run.penetration, static_cast<double>(std::max(depth, sunk)));
        const StepReport& report = *simulation.view().report;
        run.touched += report.contacts > 0 ? 1 : 0;
        run.speed = report.rms_speed;
        const auto weight = static_cast<double>(model.particle_mass * model.gravity.norm()) * model.grid.particles();
        const double lift = (report.energy.kinetic + report.energy.gravity + report.energy.spring) / weight;
        least_ = std::min(least_, lift);
        run.energy_gain = std::max(run.energy_gain, lift - least_);
    }

private:
    SearchAudit audit_;
    double least_ = std::numeric_limits<double>::infinity();
};

/// A kind of flaw, and the runs that have it.
struct RunFlaw {
    const char* name;
    bool (*has)(const CombinationRun& run);
};

constexpr RunFlaw flaws[] = {
    {"diverged", [](const CombinationRun& run) { return run.diverged; }},
    {"no_contact", [](const CombinationRun& run) { return run.touched == 0; }},
    {"penetration", [](const CombinationRun& run) { return !(run.penetration <= most_penetration); }},
    {"energy", [](const CombinationRun& run) { return !(run.energy_gain <= most_energy_gain); }},
    {"speed", [](const CombinationRun& run) { return !(run.speed <= most_speed); }},
};

}  // namespace

std::vector<Combination> all_combinations() {
    std::vector<Combination> all;
    for (const IntegratorKind integrator : values_of<IntegratorKind>()) {
        for (const ResponseKind response : values_of<ResponseKind>()) {
            for (const bool continuous : {false, true}) all.push_back({integrator, response, continuous});
        }
    }
    return all;
}

std::vector<SearchTree> all_trees() {
    std::vector<SearchTree> all;
    for (const VolumeKind volume : values_of<VolumeKind>()) {
        for (const UpdateKind update : values_of<UpdateKind>()) {
            if (volume != VolumeKind::Brute) all.push_back({volume, update});
        }
    }
    return all;
}

SearchTree sampled_tree(std::size_t number) {
    constexpr std::size_t updates = enum_names<UpdateKind>.size(), volumes = enum_names<VolumeKind>.size() - 1;
    // Both numbers go through all their values for one integrator, and from one integrator to the next
    const std::size_t integrator = number / 8, rest = number % 8;
    return all_trees()[(integrator + rest) % volumes * updates + (3 * integrator + rest) % updates];
}

CombinationRun run_combination(const Combination& combination, const SearchTree& tree, double seconds,
                               const std::vector<std::string>& changes) {
    Simulation simulation("drop", combined_settings(combination, tree, changes));
    CombinationWatch watch(simulation);
    CombinationRun run{.step = simulation.settings().solver.dt};
    while (!run.diverged && simulation.report().time < seconds) {
        simulation.step();
        run.diverged = simulation.report().status == Status::Diverged;
        watch.look(simulation, run);
    }
    run.hash = simulation.hash();
    return run;
}

std::vector<std::string> run_flaws() {
    std::vector<std::string> names{"none"};
    for (const RunFlaw& flaw : flaws) names.emplace_back(flaw.name);
    return names;
}

std::string flaw_of(const CombinationRun& run) {
    const auto found = std::ranges::find_if(flaws, [&run](const RunFlaw& flaw) { return flaw.has(run); });
    return found == std::end(flaws) ? "none" : found->name;
}

namespace {

/// A combination, by brute force and all of its trees.
Rows run_trees(const Combination& combination, const std::vector<SearchTree>& trees) {
    constexpr double simulated_seconds = 2;
    const CombinationRun expected = run_combination(combination, {}, simulated_seconds);
    for (const SearchTree& tree : trees) {
        if (run_combination(combination, tree, simulated_seconds).hash == expected.hash) continue;
        throw RunError(fmt::format("combinations: {}, {}, {}: {}, {} gives other bits than brute force",
                                   name_of(combination.integrator), name_of(combination.response),
                                   combination.continuous ? "continuous" : "discrete", name_of(tree.volume),
                                   name_of(tree.update)));
    }
    return {{{"integrator", combination.integrator},
             {"response", combination.response},
             {"detection", combination.continuous ? "continuous" : "discrete"},
             {"trees", trees.size()},
             {"step_s", expected.step},
             {"touched_steps", expected.touched},
             {"penetration_m", expected.penetration},
             {"energy_gain_m", expected.energy_gain},
             {"speed_m_per_s", expected.speed},
             {"flaw", flaw_of(expected)}}};
}

ExperimentCases combination_cases(bool quick) {
    ExperimentCases all;
    for (const Combination& combination : all_combinations()) {
        const std::size_t number = all.size();
        all.push_back([=] { return run_trees(combination, quick ? std::vector{sampled_tree(number)} : all_trees()); });
    }
    return all;
}

}  // namespace

Experiment combinations_experiment() {
    return {"combinations",
            "does every integrator work with every response, volume and update?",
            4,
            {name_column<IntegratorKind>("integrator"), name_column<ResponseKind>("response"),
             word_column("detection", {"discrete", "continuous"}),
             whole_column("trees", 1),  // with the same bits as brute force
             positive_column("step_s"), whole_column("touched_steps"), number_column("penetration_m"),
             number_column("energy_gain_m"), number_column("speed_m_per_s"), word_column("flaw", run_flaws())},
            {{"integrator", "flaw"}, {"trees", "step_s", "penetration_m", "energy_gain_m", "speed_m_per_s"}},
            {{"", combination_cases, {}}}};
}

}  // namespace drape
