#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/bounds/node_view.h"
#include "drape/bounds/quadtree_nodes.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "hierarchy_run.h"
#include "lab/experiments.h"

namespace drape {
namespace {

using Hierarchies = std::vector<BroadPhaseParameters>;

constexpr double frame_time = 1.0 / 60;  // at about the rate of a screen [s]

/// The scenes whose motion is recorded, from shortly before cloth and ball meet.
std::vector<MotionWanted> scene_motions(int frames) {
    return {{"drop", 0.1, frame_time, frames},
            {"two_corners", 0.2, frame_time, frames},
            {"curtain", 0.8, frame_time, frames}};
}

/// Particles along a side of the larger cloth on which time is set against accuracy; the charts' scripts know it, too.
constexpr int resampled_side = 128;

/// What every part with several volumes has: spheres about centroids, as the original has them, and one of each other
/// family.
constexpr VolumeKind volume_families[] = {VolumeKind::Sphere, VolumeKind::Aabb, VolumeKind::Kdop18, VolumeKind::Obb};

/// The first so many of the families, rebuilt, each alone.
std::vector<Hierarchies> families(std::size_t count, int leaf_cells) {
    std::vector<Hierarchies> all;
    for (const VolumeKind family : std::span(volume_families).first(count)) {
        all.push_back(Hierarchies{{.volume = family, .leaf_cells = leaf_cells}});
    }
    return all;
}

Hierarchies with_every_update(BroadPhaseParameters parameters) {
    Hierarchies all;
    for (const UpdateKind update : values_of<UpdateKind>()) {
        parameters.update = update;
        all.push_back(parameters);
    }
    return all;
}

/// A case for each motion and each list of hierarchies, which it measures there one after the other.
/// @param add_rows(motion, parameters, rows) about one of them
template <class AddRows>
ExperimentCases cases_of(const std::vector<MotionWanted>& wanted, const std::vector<Hierarchies>& lists,
                         const AddRows& add_rows) {
    const auto run = [add_rows, motions = std::make_shared<Motions>()](const MotionWanted& one,
                                                                       const Hierarchies& hierarchies) {
        const RecordedMotion motion = find_motion(*motions, one);
        Rows rows;
        for (const BroadPhaseParameters& parameters : hierarchies) add_rows(motion, parameters, rows);
        return rows;
    };
    return cases_over(run, Axis<MotionWanted>{"", wanted}, Axis<Hierarchies>{"", lists})(false);
}

/// A row about a hierarchy on some frames of a motion. The parts of the experiment share the columns.
Row row_of(const RecordedMotion& motion, const BroadPhaseParameters& parameters, std::span<const FrameRun> frames) {
    const double candidates = mean_over(frames, "candidates"), touching = mean_over(frames, "touching");
    Row row{{"scene", motion.scene},
            {"volume", parameters.volume},
            {"update", parameters.update},
            {"particles", motion.grid.particles()},
            {"leaf_cells", parameters.leaf_cells},
            {"interval_s", motion.interval},
            {"false_per_true", touching > 0 ? (candidates - touching) / touching : no_number}};
    for (const char* count : {"nodes", "visited", "candidates", "touching", "tightness"}) {
        row.set(count, mean_over(frames, count));
    }
    if (parameters.volume == VolumeKind::Sphere) row.set("sphere_fit", parameters.sphere_fit);
    return row;
}

/// Takes a hierarchy along a motion, and adds a row about it.
std::vector<FrameRun> add_row(const RecordedMotion& motion, const BroadPhaseParameters& parameters, const RunPlan& plan,
                              Rows& rows) {
    std::vector<FrameRun> frames = follow(motion, *make_broad_phase(parameters, motion.grid), plan);
    rows.push_back(row_of(motion, parameters, frames));
    for (const char* time : {"build_s", "query_s", "exact_s", "whole_s"}) {
        rows.back().set(time, quartiles_over(frames, time));
    }
    return frames;
}

/// Six frames of a motion.
int some_frames(const RecordedMotion& motion) { return std::max(1, static_cast<int>(motion.x.size()) / 6); }

/// Time of a frame against false candidates, nodes visited and tightness: volume, sphere fit, update and leaf size on
/// three scenes.
ExperimentCases fits(bool quick) {
    using enum SphereFit;
    using enum VolumeKind;
    Hierarchies kinds;
    for (const VolumeKind family : volume_families) kinds.push_back({.volume = family});
    for (const SphereFit fit : {Ritter, Epos14, Welzl}) kinds.push_back({.sphere_fit = fit});
    if (!quick) {
        for (const SphereFit fit : {BoxCentre, Epos6, Epos26}) kinds.push_back({.sphere_fit = fit});
        for (const VolumeKind kind : {Kdop6, Kdop14, Kdop26}) kinds.push_back({.volume = kind});
    }
    std::vector<Hierarchies> lists{Hierarchies{{.volume = Brute}}};
    for (const BroadPhaseParameters& kind : kinds) {
        for (BroadPhaseParameters parameters : with_every_update(kind)) {
            Hierarchies& leaves = lists.emplace_back();
            for (const int cells : quick ? std::vector{2, 4, 7} : std::vector{1, 2, 4, 7, 11, 15}) {
                parameters.leaf_cells = cells;
                leaves.push_back(parameters);
            }
        }
    }
    // As the scene has it, then with more particles and fewer frames, all of them with contact
    std::vector<MotionWanted> wanted = scene_motions(quick ? 40 : 120);
    for (MotionWanted finer : scene_motions(quick ? 8 : 30)) {
        finer.from += 0.2;
        finer.side = resampled_side;
        wanted.push_back(finer);
    }
    return cases_of(wanted, lists, [quick](const auto& motion, const auto& parameters, Rows& rows) {
        const RunPlan plan{.repeats = quick ? 3 : 7, .tightness_every = some_frames(motion)};
        add_row(motion, parameters, plan, rows);
    });
}

/// The same level by level: what a search knows that ends at a level, and what it has cost. One search a level, each on
/// a tree of its own: it ends there, and what it visited more than the one before it is the level's.
ExperimentCases levels(bool quick) {
    std::vector<Hierarchies> lists = families(4, 1);
    lists.push_back(Hierarchies{{.leaf_cells = 1, .sphere_fit = SphereFit::Welzl}});
    lists.push_back(Hierarchies{{.update = UpdateKind::Merge, .leaf_cells = 1}});
    const auto add_rows = [quick](const RecordedMotion& motion, BroadPhaseParameters parameters, Rows& rows) {
        const auto tree = make_quadtree_nodes(motion.grid, parameters.leaf_cells);
        const RunPlan plan{.repeats = quick ? 2 : 7, .tightness_every = some_frames(motion)};
        double visited_above = 0;
        for (int level = 0; level <= tree.back().level; ++level) {
            parameters.search.level = level;
            const std::vector<FrameRun> frames = add_row(motion, parameters, plan, rows);
            Row& row = rows.back();
            const double visited = row.number("visited");
            row.set({{"level", level},
                     {"nodes", std::ranges::count(tree, level, &QuadtreeNode::level)},
                     {"tightness", mean_over(frames, "tightness_" + std::to_string(level))},
                     {"visited", visited - std::exchange(visited_above, visited)}});
        }
    };
    return cases_of(scene_motions(quick ? 40 : 120), lists, add_rows);
}

/// Simulates a scene with one hierarchy.
/// @param x receives where the cloth is at the end
Row simulate(const std::string& scene, const BroadPhaseParameters& parameters, double time, Points& x) {
    Settings settings = load_scene(scene);
    settings.contact.self = false;
    static_cast<BroadPhaseParameters&>(settings.contact) = parameters;
    settings.solver.ledger = false;
    Simulation simulation(scene, settings);
    double missed_penetration = 0, false_contacts = 0;
    const auto steps = std::llround(time / settings.solver.dt);
    for (std::int64_t step = 0; step < steps; ++step) {
        simulation.step();
        missed_penetration = std::max(missed_penetration, simulation.report().missed_penetration);
        false_contacts += static_cast<double>(simulation.report().false_contacts) / static_cast<double>(steps);
    }
    if (simulation.report().status != Status::Ok) throw RunError(scene + ": " + simulation.report().error);
    x = simulation.cloths()[0].state.x;
    return {{"missed_penetration_m", missed_penetration}, {"false_contacts", false_contacts}};
}

/// All limits of a search: the levels, then numbers of tests to as many as there are nodes.
std::vector<SearchLimit> limits(const Grid& grid, int leaf_cells, bool quick) {
    const auto tree = make_quadtree_nodes(grid, leaf_cells);
    const auto nodes = static_cast<int>(tree.size());
    std::vector<SearchLimit> all;
    for (int level = 0; level <= tree.back().level; ++level) all.push_back({.level = level});
    const double step = quick ? 2.5 : 1.5;
    for (double tests = 1; tests < nodes; tests = std::max(tests + 1, tests * step)) {
        all.push_back({.tests = static_cast<int>(std::lround(tests))});
    }
    all.push_back({.tests = nodes});
    return all;
}

/// What a search with a budget lets through and invents while the scene is simulated with it.
ExperimentCases budgets(bool quick) {
    const auto add_rows = [quick](const RecordedMotion& motion, BroadPhaseParameters parameters, Rows& rows) {
        // Long enough for the ball to be well in the cloth
        const double time = motion.from + (quick ? 0.4 : 1.0);
        Points full, x;
        simulate(motion.scene, parameters, time, full);
        for (const SearchLimit& limit : limits(motion.grid, parameters.leaf_cells, quick)) {
            parameters.search = limit;
            add_row(motion, parameters, {.repeats = quick ? 2 : 7}, rows);
            Row& row = rows.back();
            if (limit.tests > 0) row.set("tests", limit.tests);
            if (limit.tests == 0) row.set("level", limit.level);
            row.set(simulate(motion.scene, parameters, time, x));
            row.set("distance_m", static_cast<double>((x - full).norm()) / std::sqrt(row.number("particles")));
        }
    };
    return cases_of(scene_motions(quick ? 40 : 120), families(quick ? 1 : 4, 4), add_rows);
}

/// Between frames: from one step of the scene on, a number of steps [s].
std::set<double> intervals(const std::string& scene, bool quick) {
    const auto wanted =
        quick ? std::vector{0.0, 1.6e-3, frame_time} : std::vector{0.0, 6e-4, 1.6e-3, 5e-3, frame_time, 0.05};
    const double dt = load_scene(scene).solver.dt;
    std::set<double> whole;
    for (const double interval : wanted) whole.insert(std::max(std::round(interval / dt), 1.0) * dt);
    return whole;
}

/// What the updates have cost in all, frame by frame, at several intervals between frames.
ExperimentCases break_evens(bool quick) {
    const auto add_rows = [quick](const RecordedMotion& motion, const BroadPhaseParameters& family, Rows& rows) {
        std::map<UpdateKind, std::vector<FrameRun>> runs;
        for (const BroadPhaseParameters& parameters : with_every_update(family)) {
            const RunPlan plan{.repeats = quick ? 5 : 15, .tightness_every = 5};
            runs[parameters.update] = follow(motion, *make_broad_phase(parameters, motion.grid), plan);
        }
        const auto cost = [](const FrameRun& frame) { return quartiles_over({&frame, 1}, "whole_s").median; };
        for (const BroadPhaseParameters& parameters : with_every_update(family)) {
            double sum = 0, sum_of_rebuild = 0;
            for (std::size_t k = 1; k < motion.x.size(); ++k) {
                const FrameRun& frame = runs[parameters.update][k];
                const auto moved = (motion.x[k] - motion.x[k - 1]).rowwise().norm().array();
                sum += cost(frame);
                sum_of_rebuild += cost(runs[UpdateKind::Rebuild][k]);
                rows.push_back(row_of(motion, parameters, {&frame, 1}));
                rows.back().set({{"frame", k},
                                 {"whole_s", cost(frame)},
                                 {"cumulative_s", sum},
                                 {"cumulative_s_over_rebuild_s", sum / sum_of_rebuild},
                                 {"moved", (moved > runs[UpdateKind::Refit][k].slack).cast<double>().mean()}});
            }
        }
    };
    ExperimentCases cases;
    for (MotionWanted one : scene_motions(quick ? 31 : 61)) {
        one.side = 64;  // so many particles that the hierarchy is worth its while
        std::vector<MotionWanted> wanted;
        for (const double interval : intervals(one.scene, quick)) {
            one.interval = interval;
            wanted.push_back(one);
        }
        for (const Hierarchies& family : families(quick ? 2 : 4, 4)) {
            std::ranges::move(cases_of(wanted, {family}, add_rows), std::back_inserter(cases));
        }
    }
    return cases;
}

/// Cost against the number of particles, on a motion resampled.
ExperimentCases sizes(bool quick) {
    std::vector<MotionWanted> wanted;
    // Few frames, so that they can be held at any size: the ball is in the middle of the curtain
    for (const int side : quick ? std::vector{16, 32, 64, 128, 256} : std::vector{16, 32, 64, 128, 256, 512, 1024}) {
        wanted.push_back({"curtain", 1.2, frame_time, 5, side});
    }
    std::vector<Hierarchies> lists{Hierarchies{{.volume = VolumeKind::Brute}}};
    for (const VolumeKind family : volume_families) lists.push_back(with_every_update({.volume = family}));
    return cases_of(wanted, lists, [quick](const auto& motion, const auto& parameters, Rows& rows) {
        add_row(motion, parameters, {.repeats = motion.grid.nx <= 128 ? 15 : quick ? 3 : 7}, rows);
    });
}

/// What a node's volume takes: "sphere 32 aabb 48 ... brute 0".
std::string bytes_of_nodes() {
    std::string words;
    for (const VolumeKind kind : values_of<VolumeKind>()) {
        const auto size = []<class Volume>(std::type_identity<Volume>) { return sizeof(Volume); };
        words += fmt::format("{} {} ", name_of(kind), kind == VolumeKind::Brute ? 0 : with_volume(kind, size));
    }
    return words;
}

}  // namespace

Experiment hierarchy_experiment() {
    return {"hierarchy",
            "what does a tighter hierarchy cost, and what does it save?",
            8,
            {"part", "scene", "volume", Column{"sphere_fit", "none"}, "update", "particles",
             "leaf_cells",  // 0: as measured to be fastest
             "level",       // that the row is about, or at which the search ended
             "tests",       // after which the search ended
             "interval_s",  // between frames
             "frame",
             // CPU times, over frames and repeats
             quartile_columns("build_s"), quartile_columns("query_s"), quartile_columns("exact_s"),
             quartile_columns("whole_s"),  // build, query and exact test
             "cumulative_s",               // of all frames so far, medians over repeats
             "cumulative_s_over_rebuild_s",
             // A mean frame; the same in every run
             "nodes",           // of the whole tree, or of the level
             "visited",         // by the search
             "candidates",      // cells
             "touching",        // cells
             "false_per_true",  // candidates that do not touch over those that do
             "tightness",       // mean size of nodes, over that of the smallest volume of the kind
             "moved",           // part of the particles that moved farther than a refit lets pass
             // What a limited search did to the simulated motion
             "missed_penetration_m",  // largest
             "false_contacts",        // a step
             "distance_m"},           // RMS of the particles from those of the full search, at the end
            {{"fit",
              fits,
              {{"hierarchy_fit"},
               {.name = "hierarchy_fit_128", .script = "hierarchy_fit"},
               {.name = "hierarchy_storage", .values = {{"bytes", quoted(bytes_of_nodes())}}}}},
             {"level", levels, {{"hierarchy_level"}}, "scene"},
             {"budget", budgets, {{"hierarchy_budget"}}},
             {"break_even", break_evens, {{"hierarchy_break_even"}}, "scene"},
             {"size", sizes, {{"hierarchy_size"}}}}};
}

}  // namespace drape
