#include "hierarchy_parts.h"

namespace drape {
namespace {

std::vector<VolumeVariant> variants(bool quick) {
    using enum SphereFit;
    std::vector<VolumeVariant> all(std::begin(volume_families), std::end(volume_families));
    for (const SphereFit fit : {Ritter, Epos14, Welzl}) all.push_back({VolumeKind::Sphere, fit});
    if (quick) return all;
    for (const SphereFit fit : {BoxCentre, Epos6, Epos26}) all.push_back({VolumeKind::Sphere, fit});
    for (const VolumeKind kind : {VolumeKind::Kdop6, VolumeKind::Kdop14, VolumeKind::Kdop26}) all.push_back({kind});
    return all;
}

HierarchyRow measure_fit(const RecordedMotion& motion, const BroadPhaseParameters& parameters, bool quick) {
    const auto hierarchy = make_broad_phase(parameters, motion.grid);
    const int frames = static_cast<int>(motion.x.size());
    const HierarchyRun run =
        follow(motion, *hierarchy, {.repeats = quick ? 3 : 7, .tightness_every = std::max(1, frames / 6)});
    HierarchyRow row = HierarchyRow::of("fit", motion, parameters);
    row.set_times(run);
    row.set_counts(run.counts);
    if (hierarchy->levels() > 0) row.tightness = over_levels(run.tightness).mean();
    return row;
}

}  // namespace

std::vector<HierarchyCase> fit_cases(bool quick, const SharedMotions& motions) {
    std::vector<HierarchyCase> cases;
    const std::vector<int> leaves = quick ? std::vector{2, 4, 7} : std::vector{1, 2, 4, 7, 11, 15};
    const auto add = [&](const MotionWanted& wanted, int side) {
        const auto motion_of = [motions, wanted, side] {
            const RecordedMotion& motion = motions->find(wanted);
            return side > 0 ? resampled(motion, {side, side}) : motion;
        };
        cases.push_back(
            [=] { return std::vector<HierarchyRow>{measure_fit(motion_of(), {.volume = VolumeKind::Brute}, quick)}; });
        for (const VolumeVariant& variant : variants(quick)) {
            for (const UpdateKind update : all_updates) {
                cases.push_back([=] {
                    std::vector<HierarchyRow> rows;
                    const RecordedMotion motion = motion_of();
                    for (const int leaf : leaves) {
                        rows.push_back(measure_fit(
                            motion,
                            {.volume = variant.volume, .update = update, .leaf_cells = leaf, .sphere_fit = variant.fit},
                            quick));
                    }
                    return rows;
                });
            }
        }
    };
    // As the scene has it, then with more particles and fewer frames, all of them with contact
    for (const HierarchyScene& scene : hierarchy_scenes) add(screen_frames(scene, quick ? 40 : 120), 0);
    for (const HierarchyScene& scene : hierarchy_scenes) {
        MotionWanted wanted = screen_frames(scene, quick ? 8 : 30);
        wanted.from += 0.2;
        add(wanted, resampled_side);
    }
    return cases;
}

}  // namespace drape
