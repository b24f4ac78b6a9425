#include "hierarchy_parts.h"

namespace drape {
namespace {

/// One search a level, each on a tree of its own: it ends there, and what it visited more than the one before it is
/// the level's.
std::vector<HierarchyRow> measure_level(const RecordedMotion& motion, BroadPhaseParameters parameters, bool quick) {
    const int levels = make_broad_phase(parameters, motion.grid)->levels();
    const int frames = static_cast<int>(motion.x.size());
    std::vector<HierarchyRow> rows;
    double visited_above = 0;
    for (int level = 0; level < levels; ++level) {
        parameters.search.level = level;
        const auto hierarchy = make_broad_phase(parameters, motion.grid);
        const HierarchyRun run =
            follow(motion, *hierarchy, {.repeats = quick ? 2 : 7, .tightness_every = std::max(1, frames / 6)});
        HierarchyRow row = HierarchyRow::of("level", motion, parameters);
        row.level = level;
        row.set_times(run);
        row.set_counts(run.counts);
        const Tightness& tightness = run.tightness[static_cast<std::size_t>(level)];
        const auto looked_at =
            std::ranges::count_if(run.frame_tightness, [](const Tightness& t) { return t.nodes > 0; });
        row.nodes = static_cast<double>(tightness.nodes) / static_cast<double>(looked_at);
        row.tightness = tightness.mean();
        const double visited = row.visited;
        row.visited = visited - visited_above;
        visited_above = visited;
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

std::vector<HierarchyCase> level_cases(bool quick, const SharedMotions& motions) {
    std::vector<HierarchyCase> cases;
    const auto add = [&](const HierarchyScene& scene, const VolumeVariant& variant, UpdateKind update) {
        cases.push_back([=, wanted = screen_frames(scene, quick ? 40 : 120)] {
            return measure_level(
                motions->find(wanted),
                {.volume = variant.volume, .update = update, .leaf_cells = 1, .sphere_fit = variant.fit}, quick);
        });
    };
    for (const HierarchyScene& scene : hierarchy_scenes) {
        for (const VolumeVariant& variant : volume_families) add(scene, variant, UpdateKind::Rebuild);
        add(scene, {VolumeKind::Sphere, SphereFit::Welzl}, UpdateKind::Rebuild);
        add(scene, {VolumeKind::Sphere}, UpdateKind::Merge);
    }
    return cases;
}

}  // namespace drape
