#include <cmath>

#include "drape/base/input_error.h"
#include "drape/bounds/quadtree_nodes.h"
#include "drape/sim/scene.h"
#include "drape/sim/simulation.h"
#include "hierarchy_parts.h"

namespace drape {
namespace {

/// A scene simulated with one hierarchy to the end.
struct SearchedRun {
    Points x;
    double missed_penetration = 0;  ///< largest [m]
    double false_contacts = 0;      ///< a step
};

SearchedRun simulate(const std::string& scene, const BroadPhaseParameters& parameters, double time) {
    Settings settings = load_scene(scene);
    settings.contact.volume = parameters.volume;
    settings.contact.update = parameters.update;
    settings.contact.leaf_cells = parameters.leaf_cells;
    settings.contact.search_level = parameters.search.level;
    settings.contact.search_tests = static_cast<int>(parameters.search.tests);
    settings.solver.ledger = false;
    Simulation simulation(scene, settings);
    SearchedRun run;
    const auto steps = std::llround(time / settings.solver.dt);
    for (std::int64_t step = 0; step < steps; ++step) {
        simulation.step();
        run.missed_penetration = std::max(run.missed_penetration, simulation.report().missed_penetration);
        run.false_contacts += static_cast<double>(simulation.report().false_contacts) / static_cast<double>(steps);
    }
    if (simulation.report().status != Status::Ok) throw RunError(scene + ": " + simulation.report().trouble);
    run.x = simulation.cloths()[0].state.x;
    return run;
}

/// All limits of one hierarchy: the levels, then numbers of tests to as many as there are nodes.
std::vector<SearchLimit> limits(const BroadPhaseParameters& parameters, const Grid& grid, bool quick) {
    const int levels = make_broad_phase(parameters, grid)->levels();
    const auto nodes = static_cast<std::int64_t>(make_quadtree_nodes(grid, parameters.leaf_cells).size());
    std::vector<SearchLimit> all;
    for (int level = 0; level < levels; ++level) all.push_back({.level = level});
    const double step = quick ? 2.5 : 1.5;
    for (double tests = 1; tests < static_cast<double>(nodes); tests = std::max(tests + 1, tests * step)) {
        all.push_back({.tests = std::llround(tests)});
    }
    all.push_back({.tests = nodes});
    return all;
}

std::vector<HierarchyRow> measure_budget(const RecordedMotion& motion, BroadPhaseParameters parameters, double time,
                                         bool quick) {
    const SearchedRun full = simulate(motion.scene, parameters, time);
    std::vector<HierarchyRow> rows;
    for (const SearchLimit& limit : limits(parameters, motion.grid, quick)) {
        parameters.search = limit;
        const auto hierarchy = make_broad_phase(parameters, motion.grid);
        const HierarchyRun run = follow(motion, *hierarchy, {.repeats = quick ? 2 : 7});
        HierarchyRow row = HierarchyRow::of("budget", motion, parameters);
        if (limit.tests > 0) row.tests = static_cast<double>(limit.tests);
        if (limit.tests == 0) row.level = limit.level;
        row.set_times(run);
        row.set_counts(run.counts);
        const SearchedRun limited = simulate(motion.scene, parameters, time);
        row.missed_penetration_m = limited.missed_penetration;
        row.false_contacts = limited.false_contacts;
        row.distance_m = static_cast<double>((limited.x - full.x).norm()) / std::sqrt(row.particles);
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

std::vector<HierarchyCase> budget_cases(bool quick, const SharedMotions& motions) {
    std::vector<HierarchyCase> cases;
    for (const HierarchyScene& scene : hierarchy_scenes) {
        for (const VolumeVariant& variant : volume_families) {
            if (quick && variant.volume != VolumeKind::Sphere) continue;
            // Long enough for the ball to be well in the cloth
            const double time = scene.from + (quick ? 0.4 : 1.0);
            cases.push_back([=, wanted = screen_frames(scene, quick ? 40 : 120)] {
                return measure_budget(motions->find(wanted),
                                      {.volume = variant.volume, .leaf_cells = 4, .sphere_fit = variant.fit}, time,
                                      quick);
            });
        }
    }
    return cases;
}

}  // namespace drape
