#include <algorithm>
#include <cmath>
#include <set>

#include "drape/sim/scene.h"
#include "hierarchy_parts.h"

namespace drape {
namespace {

/// Particles along each side: so many that the hierarchy is worth its while.
constexpr int side = 64;

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

/// The part of the particles that has moved farther than `reach` since the frame before.
double moved_part(const RecordedMotion& motion, std::size_t frame, Real reach) {
    const auto distances = (motion.x[frame] - motion.x[frame - 1]).rowwise().norm().array();
    return static_cast<double>((distances > reach).count()) / static_cast<double>(distances.size());
}

std::vector<HierarchyRow> measure_break_even(const RecordedMotion& motion, const VolumeVariant& variant, bool quick) {
    std::vector<HierarchyRun> runs;
    for (const UpdateKind update : all_updates) {
        const auto hierarchy = make_broad_phase(
            {.volume = variant.volume, .update = update, .leaf_cells = 4, .sphere_fit = variant.fit}, motion.grid);
        runs.push_back(follow(motion, *hierarchy, {.repeats = quick ? 5 : 15, .tightness_every = 5}));
    }
    const std::vector<double> rebuild = frame_costs(runs[static_cast<std::size_t>(UpdateKind::Rebuild)]);
    const std::vector<Real>& slack = runs[static_cast<std::size_t>(UpdateKind::Refit)].slack;
    std::vector<HierarchyRow> rows;
    for (const UpdateKind update : all_updates) {
        const HierarchyRun& run = runs[static_cast<std::size_t>(update)];
        const std::vector<double> costs = frame_costs(run);
        double sum = 0, sum_of_rebuild = 0;
        for (std::size_t k = 1; k < costs.size(); ++k) {
            sum += costs[k];
            sum_of_rebuild += rebuild[k];
            HierarchyRow row = HierarchyRow::of(
                "break_even", motion,
                {.volume = variant.volume, .update = update, .leaf_cells = 4, .sphere_fit = variant.fit});
            row.frame = static_cast<double>(k);
            row.whole_s = costs[k];
            row.cumulative_s = sum;
            row.cumulative_s_over_rebuild_s = sum / sum_of_rebuild;
            row.set_counts({run.counts[k]});
            if (run.frame_tightness[k].nodes > 0) row.tightness = run.frame_tightness[k].mean();
            row.moved = moved_part(motion, k, slack[k]);
            rows.push_back(row);
        }
    }
    return rows;
}

/// Between frames: from one step of the scene on, in whole steps [s].
std::set<double> intervals(const HierarchyScene& scene, bool quick) {
    const auto wanted =
        quick ? std::vector{0.0, 1.6e-3, 1.0 / 60} : std::vector{0.0, 6e-4, 1.6e-3, 5e-3, 1.0 / 60, 0.05};
    const double dt = load_scene(scene.name).solver.dt;
    std::set<double> whole;
    for (const double interval : wanted) whole.insert(std::max(std::round(interval / dt), 1.0) * dt);
    return whole;
}

}  // namespace

std::vector<HierarchyCase> break_even_cases(bool quick, const SharedMotions& motions) {
    std::vector<HierarchyCase> cases;
    for (const HierarchyScene& scene : hierarchy_scenes) {
        for (const VolumeVariant& variant : volume_families) {
            if (quick && variant.volume != VolumeKind::Sphere && variant.volume != VolumeKind::Aabb) continue;
            for (const double interval : intervals(scene, quick)) {
                const MotionWanted wanted{scene.name, scene.from, interval, quick ? 31 : 61};
                cases.push_back([=] {
                    return measure_break_even(resampled(motions->find(wanted), {side, side}), variant, quick);
                });
            }
        }
    }
    return cases;
}

}  // namespace drape
