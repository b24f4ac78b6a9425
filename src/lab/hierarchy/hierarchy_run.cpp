#include "hierarchy_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drape/base/assert.h"
#include "drape/base/input_error.h"
#include "drape/bounds/node_view.h"
#include "drape/contact/detection.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

/// As `tightness_of` has sizes [m].
Real size_of(const BoundingSphere& sphere) { return sphere.radius; }
Real size_of(const Aabb& box) { return (box.high - box.low).mean() / 2; }
Real size_of(const Obb& box) { return (box.high - box.low).mean() / 2; }

template <int K>
Real size_of(const KDop<K>& dop) {
    Real widths = (dop.box.high - dop.box.low).sum();
    for (std::size_t k = 0; k < KDop<K>::cuts; ++k) {
        widths += (dop.high[k] - dop.low[k]) / dop_length(dop_numbers<K>[k + 3]);
    }
    return widths / K;
}

Real size_of(const NodeView& node) {
    return std::visit([](const auto& volume) { return size_of(volume); }, node.volume);
}

double mean_of(const std::vector<double>& values) {
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return values.empty() ? no_number : sum / static_cast<double>(values.size());
}

/// A query of a small cloth is hardly longer than reading the clock: so many are timed together.
constexpr int queries_in_a_row = 8;

/// Ends the run where a search and brute force do not find the same triangles. Where the search has ended early, the
/// nodes that it has not opened must hold what it has not found.
/// @param triangles, expected ascending
void demand_the_same(const RecordedMotion& motion, std::size_t frame, std::span<const StoppedNode> stopped,
                     const std::vector<int>& triangles, const std::vector<int>& expected) {
    std::vector<int> differing;
    std::ranges::set_symmetric_difference(triangles, expected, std::back_inserter(differing));
    for (const int triangle : differing) {
        const bool was_found = std::ranges::binary_search(triangles, triangle);
        const bool touches = std::ranges::binary_search(expected, triangle);
        const int cell = triangle / 2, columns = motion.grid.cell_columns();
        const auto holds = [=](const StoppedNode& node) { return node.holds(cell % columns, cell / columns); };
        if (!was_found && std::ranges::any_of(stopped, holds)) continue;
        throw RunError(fmt::format("{}, frame {}: triangle {} {}", motion.scene, frame, triangle,
                                   !was_found ? "touches the ball, and the search has missed it"
                                   : touches  ? "was found twice"
                                              : "was found, but brute force finds that it is free"));
    }
}

}  // namespace

RecordedMotion record_motion(const MotionWanted& wanted, Settings settings) {
    settings.solver.sleep_speed = 0;
    settings.solver.ledger = false;
    const double dt = settings.solver.dt;
    const Real h = static_cast<Real>(dt), thickness = settings.contact.thickness;
    Simulation simulation(wanted.scene, settings);
    DRAPE_ASSERT(!simulation.balls().empty());
    const Cloth& cloth = simulation.cloths()[0];
    const Grid grid = cloth.model.grid;
    const auto integrator = make_integrator(settings.solver, grid);

    const int steps_between = std::max(static_cast<int>(std::lround(wanted.interval / dt)), 1);
    RecordedMotion motion{.scene = wanted.scene, .grid = grid, .interval = steps_between * dt, .from = wanted.from};
    const auto first = static_cast<std::int64_t>(std::llround(wanted.from / dt));
    const std::int64_t last = first + static_cast<std::int64_t>(wanted.frames - 1) * steps_between;
    for (std::int64_t step = 0; step <= last; ++step) {
        const bool kept = step >= first && (step - first) % steps_between == 0;
        if (kept) {
            ClothState next = cloth.state;
            integrator->step(cloth.model, next, h);
            motion.x.push_back(std::move(next.x));
        }
        simulation.step();
        if (kept) motion.balls.push_back(grown(simulation.balls()[0], thickness));
    }
    if (simulation.report().status != Status::Ok) throw RunError(wanted.scene + ": " + simulation.report().error);
    return motion;
}

RecordedMotion find_motion(Motions& motions, const MotionWanted& wanted) {
    RecordedMotion& recorded = motions[{wanted.scene, wanted.from, wanted.interval, wanted.frames}];
    if (recorded.x.empty()) recorded = record_motion(wanted, load_scene(wanted.scene));
    RecordedMotion motion = recorded;
    if (wanted.side == 0) return motion;
    motion.grid = {wanted.side, wanted.side};
    for (Points& x : motion.x) x = resampled(x, recorded.grid, motion.grid);
    return motion;
}

Row tightness_of(const BroadPhase& hierarchy, const Grid& grid, const Points& x) {
    Row tightness;
    std::vector<double> all;
    for (int level = 0; level < hierarchy.levels(); ++level) {
        std::vector<NodeView> nodes;
        hierarchy.nodes_at(level, nodes);
        std::erase_if(nodes, [level](const NodeView& node) { return node.cells.level != level; });
        std::vector<NodeView> smallest = nodes;
        const auto kind = static_cast<VolumeKind>(nodes.front().volume.index());
        refit_nodes({.volume = kind, .sphere_fit = SphereFit::Welzl}, grid, x, smallest);
        std::vector<double> ratios;
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const Real least = size_of(smallest[n]);
            if (least > 0) ratios.push_back(static_cast<double>((size_of(nodes[n]) + hierarchy.slack()) / least));
        }
        tightness.set("tightness_" + std::to_string(level), mean_of(ratios));
        all.insert(all.end(), ratios.begin(), ratios.end());
    }
    tightness.set("tightness", mean_of(all));
    return tightness;
}

std::vector<FrameRun> follow(const RecordedMotion& motion, BroadPhase& hierarchy, const RunPlan& plan) {
    const CellRange all = all_cells(motion.grid);
    Candidates found;
    std::vector<int> triangles, expected;
    const auto test = [&motion](std::size_t frame, std::span<const CellRange> cells, std::vector<int>& touched) {
        find_touched_triangles(motion.grid, motion.x[frame], motion.balls[frame], 0, cells, touched, Kernels::Vector);
    };
    std::vector<FrameRun> frames;
    for (std::size_t k = 0; k < motion.x.size(); ++k) {
        hierarchy.build(motion.x[k]);
        const TraversalStats stats = hierarchy.query(motion.balls[k], found);
        test(k, found.cells, triangles);
        test(k, {&all, 1}, expected);
        std::ranges::sort(triangles);
        demand_the_same(motion, k, found.stopped, triangles, expected);
        std::int64_t candidates = stats.candidates, touching = 0;
        for (const StoppedNode& node : found.stopped) candidates += node.cells();
        for (std::size_t t = 0; t < expected.size(); ++t) {
            if (t == 0 || expected[t] / 2 != expected[t - 1] / 2) ++touching;
        }
        frames.push_back({.counts = {{"nodes", stats.nodes},
                                     {"visited", stats.visited},
                                     {"candidates", candidates},
                                     {"touching", touching}},
                          .slack = hierarchy.slack()});
        if (plan.tightness_every == 0 || k % static_cast<std::size_t>(plan.tightness_every) != 0) continue;
        frames.back().counts.set(tightness_of(hierarchy, motion.grid, motion.x[k]));
    }
    std::vector<double> costs_of_clock(1001);
    for (double& cost : costs_of_clock) cost = cpu_time_of([] {});
    const double clock = quartiles_of(costs_of_clock).median;  // read twice [s]
    const auto seconds = [clock](int runs, const auto& work) {
        return std::max(cpu_time_of(work, runs) - clock / runs, 0.0);
    };
    for (int repeat = 0; repeat < plan.repeats; ++repeat) {
        for (std::size_t k = 0; k < motion.x.size(); ++k) {
            const double build = seconds(1, [&] { hierarchy.build(motion.x[k]); });
            const double query = seconds(queries_in_a_row, [&] { hierarchy.query(motion.balls[k], found); });
            const double exact = seconds(queries_in_a_row, [&] { test(k, found.cells, triangles); });
            if (k == 0) continue;
            frames[k].times.push_back(
                {{"build_s", build}, {"query_s", query}, {"exact_s", exact}, {"whole_s", build + query + exact}});
        }
    }
    return frames;
}

Quartiles quartiles_over(std::span<const FrameRun> frames, const std::string& time) {
    std::vector<double> times;
    for (const FrameRun& frame : frames) {
        for (const Row& one : frame.times) times.push_back(one.number(time));
    }
    return quartiles_of(std::move(times));
}

double mean_over(std::span<const FrameRun> frames, const std::string& count) {
    std::vector<double> counts;
    for (const FrameRun& frame : frames) {
        if (frame.counts.has(count)) counts.push_back(frame.counts.number(count));
    }
    return mean_of(counts);
}

}  // namespace drape
