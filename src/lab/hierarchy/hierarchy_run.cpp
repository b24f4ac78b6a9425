#include "hierarchy_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "drape/base/assert.h"
#include "drape/base/input_error.h"
#include "drape/contact/detection.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"
#include "lab/measure/states.h"

namespace drape {
namespace {

/// A query of a small cloth is hardly longer than reading the clock: so many are timed together.
constexpr int queries_in_a_row = 8;

/// What reading the clock twice costs [s].
double clock_cost() {
    std::vector<double> costs(1001);
    for (double& cost : costs) {
        const double before = thread_cpu_time();
        cost = thread_cpu_time() - before;
    }
    return quartiles_of(costs).median;
}

/// Follows one motion with one hierarchy.
class Follower {
public:
    Follower(const RecordedMotion& motion, BroadPhase& hierarchy) : motion_(motion), hierarchy_(hierarchy) {
        list_all_cells(motion.grid, all_cells_);
    }

    /// One frame, and whether brute force finds the same.
    FrameCounts check(std::size_t frame) {
        hierarchy_.build(motion_.x[frame]);
        FrameCounts counts{.traversal = hierarchy_.query(motion_.balls[frame], found_)};
        test(frame, found_.cells, triangles_);
        test(frame, all_cells_, expected_);
        std::ranges::sort(triangles_);
        demand_no_invention(frame);
        demand_none_missed(frame);
        counts.candidates = counts.traversal.candidates;
        for (const StoppedNode& node : found_.stopped) {
            counts.candidates += static_cast<std::int64_t>(node.i1 - node.i0) * (node.j1 - node.j0);
        }
        for (std::size_t k = 0; k < expected_.size(); ++k) {
            if (k == 0 || expected_[k] / 2 != expected_[k - 1] / 2) ++counts.touching;
        }
        return counts;
    }

    FrameTimes time(std::size_t frame) {
        FrameTimes times;
        double last = thread_cpu_time();
        const auto lap = [&](int runs) {
            const double now = thread_cpu_time();
            const double seconds = std::max(now - last - clock_cost_, 0.0) / runs;
            last = thread_cpu_time();
            return seconds;
        };
        hierarchy_.build(motion_.x[frame]);
        times.build = lap(1);
        for (int k = 0; k < queries_in_a_row; ++k) hierarchy_.query(motion_.balls[frame], found_);
        times.query = lap(queries_in_a_row);
        for (int k = 0; k < queries_in_a_row; ++k) test(frame, found_.cells, triangles_);
        times.exact = lap(queries_in_a_row);
        return times;
    }

private:
    void test(std::size_t frame, std::span<const CellRun> cells, std::vector<int>& triangles) const {
        find_touched_triangles(motion_.grid, motion_.x[frame], motion_.balls[frame], 0, cells, triangles,
                               Kernels::Vector);
    }

    [[noreturn]] void disagree(std::size_t frame, int triangle, const std::string& how) const {
        throw RunError(fmt::format("{}, frame {}: triangle {} {}", motion_.scene, frame, triangle, how));
    }

    void demand_no_invention(std::size_t frame) const {
        if (const auto twice = std::ranges::adjacent_find(triangles_); twice != triangles_.end()) {
            disagree(frame, *twice, "was found twice");
        }
        if (!std::ranges::includes(expected_, triangles_)) {
            disagree(frame, triangles_.front(), "or one after it was found, but brute force finds that it is free");
        }
    }

    /// Where the search has ended early, the nodes that it has not opened must hold what it has not found.
    void demand_none_missed(std::size_t frame) const {
        const int columns = motion_.grid.cell_columns();
        for (const int triangle : expected_) {
            const int i = triangle / 2 % columns, j = triangle / 2 / columns;
            const auto holds = [&](const StoppedNode& node) {
                return i >= node.i0 && i < node.i1 && j >= node.j0 && j < node.j1;
            };
            if (std::ranges::binary_search(triangles_, triangle) || std::ranges::any_of(found_.stopped, holds)) {
                continue;
            }
            disagree(frame, triangle, "touches the ball, and the search has missed it");
        }
    }

    const RecordedMotion& motion_;
    BroadPhase& hierarchy_;
    const double clock_cost_ = clock_cost();
    std::vector<CellRun> all_cells_;
    Candidates found_;
    std::vector<int> triangles_, expected_;
};

}  // namespace

RecordedMotion record_motion(const MotionWanted& wanted) { return record_motion(wanted, load_scene(wanted.scene)); }

RecordedMotion record_motion(const MotionWanted& wanted, Settings settings) {
    settings.solver.sleep_speed = 0;
    settings.solver.ledger = false;
    const double dt = settings.solver.dt;
    const Real h = static_cast<Real>(dt), thickness = settings.contact.thickness;
    Simulation simulation(wanted.scene, settings);
    DRAPE_ASSERT(!simulation.balls().empty());
    const Cloth& cloth = simulation.cloths()[0];
    const Grid grid = cloth.model.grid;
    const auto integrator = make_integrator(integrator_of(settings.solver), grid);

    const int steps_between = std::max(static_cast<int>(std::lround(wanted.interval / dt)), 1);
    RecordedMotion motion{.scene = wanted.scene, .grid = grid, .interval = steps_between * dt, .x = {}, .balls = {}};
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

RecordedMotion resampled(const RecordedMotion& motion, const Grid& grid) {
    RecordedMotion finer{
        .scene = motion.scene, .grid = grid, .interval = motion.interval, .x = {}, .balls = motion.balls};
    for (const Points& x : motion.x) finer.x.push_back(resampled(x, motion.grid, grid));
    return finer;
}

RecordedMotion Motions::find(const MotionWanted& wanted) {
    RecordedMotion& motion = recorded_[{wanted.scene, wanted.from, wanted.interval, wanted.frames}];
    if (motion.x.empty()) motion = record_motion(wanted);
    return wanted.side > 0 ? resampled(motion, {wanted.side, wanted.side}) : motion;
}

HierarchyRun follow(const RecordedMotion& motion, BroadPhase& hierarchy, const RunPlan& plan) {
    Follower follower(motion, hierarchy);
    HierarchyRun run{.times = std::vector<std::vector<FrameTimes>>(motion.x.size()),
                     .counts = {},
                     .tightness = {},
                     .frame_tightness = std::vector<Tightness>(motion.x.size()),
                     .slack = {}};
    for (std::size_t k = 0; k < motion.x.size(); ++k) {
        run.counts.push_back(follower.check(k));
        run.slack.push_back(hierarchy.slack());
        if (plan.tightness_every == 0 || k % static_cast<std::size_t>(plan.tightness_every) != 0) continue;
        std::vector<Tightness> levels;
        add_tightness(hierarchy, motion.grid, motion.x[k], levels);
        run.frame_tightness[k] = over_levels(levels);
        run.tightness.resize(levels.size());
        for (std::size_t level = 0; level < levels.size(); ++level) run.tightness[level] += levels[level];
    }
    for (int repeat = 0; repeat < plan.repeats; ++repeat) {
        for (std::size_t k = 0; k < motion.x.size(); ++k) run.times[k].push_back(follower.time(k));
    }
    return run;
}

double false_per_true(const std::vector<FrameCounts>& counts) {
    std::int64_t candidates = 0, touching = 0;
    for (const FrameCounts& frame : counts) candidates += frame.candidates, touching += frame.touching;
    return touching > 0 ? static_cast<double>(candidates - touching) / static_cast<double>(touching) : no_number;
}

}  // namespace drape
