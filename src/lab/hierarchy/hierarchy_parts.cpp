#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/bounds/quadtree_nodes.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "hierarchy.h"
#include "lab/measure/methods.h"

namespace drape {
namespace {

/// A row about a hierarchy on some frames of a motion. The parts of the experiment share the columns.
Row row_of(const char* part, const RecordedMotion& motion, const BroadPhaseParameters& parameters,
           const std::vector<FrameCounts>& counts) {
    Row row{{"part", part},
            {"scene", motion.scene},
            {"volume", parameters.volume},
            {"update", parameters.update},
            {"particles", motion.grid.particles()},
            {"leaf_cells", parameters.leaf_cells},
            {"interval_s", motion.interval},
            {"nodes", mean_over_frames(counts, [](const FrameCounts& one) { return one.traversal.nodes; })},
            {"visited", mean_over_frames(counts, [](const FrameCounts& one) { return one.traversal.visited; })},
            {"candidates", mean_over_frames(counts, &FrameCounts::candidates)},
            {"touching", mean_over_frames(counts, &FrameCounts::touching)},
            {"false_per_true", false_per_true(counts)}};
    if (parameters.volume == VolumeKind::Sphere) row.set("sphere_fit", parameters.sphere_fit);
    return row;
}

/// A case that measures some hierarchies on one motion.
/// @param add_rows(motion, parameters, quick, rows) about one of them
template <class AddRows>
ExperimentCase case_of(bool quick, const SharedMotions& motions, const MotionWanted& wanted,
                       const std::vector<BroadPhaseParameters>& hierarchies, AddRows add_rows) {
    return [=] {
        const RecordedMotion motion = motions->find(wanted);
        Rows rows;
        for (const BroadPhaseParameters& parameters : hierarchies) add_rows(motion, parameters, quick, rows);
        return rows;
    };
}

/// Takes a hierarchy along a motion, and adds a row about it.
HierarchyRun add_row(const char* part, const RecordedMotion& motion, const BroadPhaseParameters& parameters,
                     const RunPlan& plan, Rows& rows) {
    const auto hierarchy = make_broad_phase(parameters, motion.grid);
    HierarchyRun run = follow(motion, *hierarchy, plan);
    rows.push_back(row_of(part, motion, parameters, run.counts));
    rows.back().set({{"build_s", quartiles_over_frames(run, &FrameTimes::build)},
                     {"query_s", quartiles_over_frames(run, &FrameTimes::query)},
                     {"exact_s", quartiles_over_frames(run, &FrameTimes::exact)},
                     {"whole_s", quartiles_over_frames(run, &FrameTimes::whole)}});
    return run;
}

/// Six frames of a motion.
int some_frames(const RecordedMotion& motion) { return std::max(1, static_cast<int>(motion.x.size()) / 6); }

std::vector<BroadPhaseParameters> volumes_and_fits(bool quick) {
    using enum SphereFit;
    using enum VolumeKind;
    std::vector<BroadPhaseParameters> all;
    for (const VolumeKind family : volume_families) all.push_back({.volume = family});
    for (const SphereFit fit : {Ritter, Epos14, Welzl}) all.push_back({.sphere_fit = fit});
    if (quick) return all;
    for (const SphereFit fit : {BoxCentre, Epos6, Epos26}) all.push_back({.sphere_fit = fit});
    for (const VolumeKind kind : {Kdop6, Kdop14, Kdop26}) all.push_back({.volume = kind});
    return all;
}

void measure_fit(const RecordedMotion& motion, const BroadPhaseParameters& parameters, bool quick, Rows& rows) {
    const RunPlan plan{.repeats = quick ? 3 : 7, .tightness_every = some_frames(motion)};
    const HierarchyRun run = add_row("fit", motion, parameters, plan, rows);
    if (!run.tightness.empty()) rows.back().set("tightness", over_levels(run.tightness).mean());
}

void measure_size(const RecordedMotion& motion, const BroadPhaseParameters& parameters, bool quick, Rows& rows) {
    add_row("size", motion, parameters, {.repeats = motion.grid.nx <= 128 ? 15 : quick ? 3 : 7}, rows);
}

/// One search a level, each on a tree of its own: it ends there, and what it visited more than the one before it is
/// the level's.
void measure_level(const RecordedMotion& motion, BroadPhaseParameters parameters, bool quick, Rows& rows) {
    const int levels = make_broad_phase(parameters, motion.grid)->levels();
    double visited_above = 0;
    for (int level = 0; level < levels; ++level) {
        parameters.search.level = level;
        const HierarchyRun run = add_row("level", motion, parameters,
                                         {.repeats = quick ? 2 : 7, .tightness_every = some_frames(motion)}, rows);
        Row& row = rows.back();
        const double visited = row.number("visited");
        const Tightness& tightness = run.tightness[static_cast<std::size_t>(level)];
        const auto looked_at =
            std::ranges::count_if(run.frame_tightness, [](const Tightness& t) { return t.nodes > 0; });
        row.set({{"level", level},
                 {"nodes", static_cast<double>(tightness.nodes) / static_cast<double>(looked_at)},
                 {"tightness", tightness.mean()},
                 {"visited", visited - std::exchange(visited_above, visited)}});
    }
}

/// A scene simulated with one hierarchy to the end.
struct SearchedRun {
    Points x;
    double missed_penetration = 0;  ///< largest [m]
    double false_contacts = 0;      ///< a step
};

SearchedRun simulate(const std::string& scene, const BroadPhaseParameters& parameters, double time) {
    Settings settings = load_scene(scene);
    settings.contact.self = false;
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
    if (simulation.report().status != Status::Ok) throw RunError(scene + ": " + simulation.report().error);
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

void measure_budget(const RecordedMotion& motion, BroadPhaseParameters parameters, bool quick, Rows& rows) {
    // Long enough for the ball to be well in the cloth
    const HierarchyScene& scene = *std::ranges::find(hierarchy_scenes, motion.scene, &HierarchyScene::name);
    const double time = scene.from + (quick ? 0.4 : 1.0);
    const SearchedRun full = simulate(motion.scene, parameters, time);
    for (const SearchLimit& limit : limits(parameters, motion.grid, quick)) {
        parameters.search = limit;
        add_row("budget", motion, parameters, {.repeats = quick ? 2 : 7}, rows);
        Row& row = rows.back();
        if (limit.tests > 0) row.set("tests", limit.tests);
        if (limit.tests == 0) row.set("level", limit.level);
        const SearchedRun limited = simulate(motion.scene, parameters, time);
        row.set(
            {{"missed_penetration_m", limited.missed_penetration},
             {"false_contacts", limited.false_contacts},
             {"distance_m", static_cast<double>((limited.x - full.x).norm()) / std::sqrt(row.number("particles"))}});
    }
}

/// The median over repeats of what each frame cost as a whole [s].
std::vector<double> frame_costs(const HierarchyRun& run) {
    std::vector<double> costs;
    for (const std::vector<FrameTimes>& repeats : run.times) {
        std::vector<double> times;
        for (const FrameTimes& frame : repeats) times.push_back(frame.whole());
        costs.push_back(quartiles_of(std::move(times)).median);
    }
    return costs;
}

/// The part of the particles that has moved farther than a distance since the frame before.
double moved_part(const RecordedMotion& motion, std::size_t frame, Real distance) {
    const auto moved = (motion.x[frame] - motion.x[frame - 1]).rowwise().norm().array();
    return static_cast<double>((moved > distance).count()) / static_cast<double>(moved.size());
}

void measure_break_even(const RecordedMotion& motion, BroadPhaseParameters parameters, bool quick, Rows& rows) {
    std::vector<HierarchyRun> runs;
    for (const UpdateKind update : values_of<UpdateKind>()) {
        parameters.update = update;
        const auto hierarchy = make_broad_phase(parameters, motion.grid);
        runs.push_back(follow(motion, *hierarchy, {.repeats = quick ? 5 : 15, .tightness_every = 5}));
    }
    const std::vector<double> rebuild = frame_costs(runs[static_cast<std::size_t>(UpdateKind::Rebuild)]);
    const std::vector<Real>& slack = runs[static_cast<std::size_t>(UpdateKind::Refit)].slack;
    for (const UpdateKind update : values_of<UpdateKind>()) {
        parameters.update = update;
        const HierarchyRun& run = runs[static_cast<std::size_t>(update)];
        const std::vector<double> costs = frame_costs(run);
        double sum = 0, sum_of_rebuild = 0;
        for (std::size_t k = 1; k < costs.size(); ++k) {
            sum += costs[k];
            sum_of_rebuild += rebuild[k];
            rows.push_back(row_of("break_even", motion, parameters, {run.counts[k]}));
            rows.back().set({{"frame", k},
                             {"whole_s", costs[k]},
                             {"cumulative_s", sum},
                             {"cumulative_s_over_rebuild_s", sum / sum_of_rebuild},
                             {"moved", moved_part(motion, k, slack[k])}});
            if (run.frame_tightness[k].nodes > 0) rows.back().set("tightness", run.frame_tightness[k].mean());
        }
    }
}

/// Between frames: from one step of the scene on, a number of steps [s].
std::set<double> intervals(const HierarchyScene& scene, bool quick) {
    const auto wanted =
        quick ? std::vector{0.0, 1.6e-3, 1.0 / 60} : std::vector{0.0, 6e-4, 1.6e-3, 5e-3, 1.0 / 60, 0.05};
    const double dt = load_scene(scene.name).solver.dt;
    std::set<double> whole;
    for (const double interval : wanted) whole.insert(std::max(std::round(interval / dt), 1.0) * dt);
    return whole;
}

}  // namespace

ExperimentCases hierarchy_fits(bool quick, const SharedMotions& motions) {
    ExperimentCases cases;
    const auto add = [&](const MotionWanted& wanted) {
        cases.push_back(case_of(quick, motions, wanted, {{.volume = VolumeKind::Brute}}, measure_fit));
        for (BroadPhaseParameters parameters : volumes_and_fits(quick)) {
            for (const UpdateKind update : values_of<UpdateKind>()) {
                parameters.update = update;
                std::vector<BroadPhaseParameters> leaves;
                for (const int cells : quick ? std::vector{2, 4, 7} : std::vector{1, 2, 4, 7, 11, 15}) {
                    leaves.push_back(parameters);
                    leaves.back().leaf_cells = cells;
                }
                cases.push_back(case_of(quick, motions, wanted, leaves, measure_fit));
            }
        }
    };
    // As the scene has it, then with more particles and fewer frames, all of them with contact
    for (const HierarchyScene& scene : hierarchy_scenes) add(scene.frames(quick ? 40 : 120));
    for (const HierarchyScene& scene : hierarchy_scenes) {
        MotionWanted wanted = scene.frames(quick ? 8 : 30);
        wanted.from += 0.2;
        wanted.side = resampled_side;
        add(wanted);
    }
    return cases;
}

ExperimentCases hierarchy_levels(bool quick, const SharedMotions& motions) {
    std::vector<BroadPhaseParameters> hierarchies;
    for (const VolumeKind family : volume_families) hierarchies.push_back({.volume = family, .leaf_cells = 1});
    hierarchies.push_back({.leaf_cells = 1, .sphere_fit = SphereFit::Welzl});
    hierarchies.push_back({.update = UpdateKind::Merge, .leaf_cells = 1});
    ExperimentCases cases;
    for (const HierarchyScene& scene : hierarchy_scenes) {
        for (const BroadPhaseParameters& parameters : hierarchies) {
            cases.push_back(case_of(quick, motions, scene.frames(quick ? 40 : 120), {parameters}, measure_level));
        }
    }
    return cases;
}

ExperimentCases hierarchy_budgets(bool quick, const SharedMotions& motions) {
    ExperimentCases cases;
    for (const HierarchyScene& scene : hierarchy_scenes) {
        for (const VolumeKind family : volume_families) {
            if (quick && family != VolumeKind::Sphere) continue;
            cases.push_back(case_of(quick, motions, scene.frames(quick ? 40 : 120),
                                    {{.volume = family, .leaf_cells = 4}}, measure_budget));
        }
    }
    return cases;
}

ExperimentCases hierarchy_break_evens(bool quick, const SharedMotions& motions) {
    ExperimentCases cases;
    for (const HierarchyScene& scene : hierarchy_scenes) {
        for (const VolumeKind family : volume_families) {
            if (quick && family != VolumeKind::Sphere && family != VolumeKind::Aabb) continue;
            for (const double interval : intervals(scene, quick)) {
                // So many particles that the hierarchy is worth its while
                const MotionWanted wanted{scene.name, scene.from, interval, quick ? 31 : 61, 64};
                cases.push_back(
                    case_of(quick, motions, wanted, {{.volume = family, .leaf_cells = 4}}, measure_break_even));
            }
        }
    }
    return cases;
}

ExperimentCases hierarchy_sizes(bool quick, const SharedMotions& motions) {
    ExperimentCases cases;
    for (const int side : quick ? std::vector{16, 32, 64, 128, 256} : std::vector{16, 32, 64, 128, 256, 512, 1024}) {
        // Few frames, so that they can be held at any size: the ball is in the middle of the curtain
        const MotionWanted wanted{"curtain", 1.2, 1.0 / 60, 5, side};
        cases.push_back(case_of(quick, motions, wanted, {{.volume = VolumeKind::Brute}}, measure_size));
        for (const VolumeKind family : volume_families) {
            std::vector<BroadPhaseParameters> hierarchies;
            for (const UpdateKind update : values_of<UpdateKind>()) {
                hierarchies.push_back({.volume = family, .update = update});
            }
            cases.push_back(case_of(quick, motions, wanted, hierarchies, measure_size));
        }
    }
    return cases;
}

}  // namespace drape
