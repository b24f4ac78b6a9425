#include "hierarchy_parts.h"

namespace drape {
namespace {

HierarchyRow measure_size(const RecordedMotion& motion, const BroadPhaseParameters& parameters, bool quick) {
    const auto hierarchy = make_broad_phase(parameters, motion.grid);
    const bool small = motion.grid.nx <= 128;
    const HierarchyRun run = follow(motion, *hierarchy, {.repeats = small ? 15 : (quick ? 3 : 7)});
    HierarchyRow row = HierarchyRow::of("size", motion, parameters);
    row.set_times(run);
    row.set_counts(run.counts);
    return row;
}

}  // namespace

std::vector<HierarchyCase> size_cases(bool quick, const SharedMotions& motions) {
    std::vector<HierarchyCase> cases;
    // Few frames, so that they can be held at any size: the ball is in the middle of the curtain
    const MotionWanted wanted{.scene = "curtain", .from = 1.2, .interval = 1.0 / 60, .frames = 5};
    const auto frames_of = [motions, wanted](int side) { return resampled(motions->find(wanted), {side, side}); };
    for (const int side : quick ? std::vector{16, 32, 64, 128, 256} : std::vector{16, 32, 64, 128, 256, 512, 1024}) {
        cases.push_back([=] {
            return std::vector<HierarchyRow>{measure_size(frames_of(side), {.volume = VolumeKind::Brute}, quick)};
        });
        for (const VolumeVariant& variant : volume_families) {
            cases.push_back([=] {
                const RecordedMotion motion = frames_of(side);
                std::vector<HierarchyRow> rows;
                for (const UpdateKind update : all_updates) {
                    rows.push_back(measure_size(
                        motion, {.volume = variant.volume, .update = update, .sphere_fit = variant.fit}, quick));
                }
                return rows;
            });
        }
    }
    return cases;
}

}  // namespace drape
