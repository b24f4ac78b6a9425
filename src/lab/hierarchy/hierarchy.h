#pragma once

#include <memory>

#include "drape/bounds/broad_phase.h"
#include "hierarchy_run.h"
#include "lab/experiment/experiment.h"

namespace drape {

/// What cases record is kept for the others of the same program.
using SharedMotions = std::shared_ptr<Motions>;

// The cases of each part; `quick` means fewer frames, hierarchies and repeats.

/// Time a frame against false candidates, nodes visited and tightness: volume, sphere fit, update and leaf size on
/// three scenes.
ExperimentCases hierarchy_fits(bool quick, const SharedMotions& motions);

/// The same level by level: what a search knows that ends at a level, and what it has cost.
ExperimentCases hierarchy_levels(bool quick, const SharedMotions& motions);

/// What a search with a budget lets through and invents while the scene is simulated with it.
ExperimentCases hierarchy_budgets(bool quick, const SharedMotions& motions);

/// What the updates have cost in all, frame by frame, at several intervals between frames.
ExperimentCases hierarchy_break_evens(bool quick, const SharedMotions& motions);

/// Cost against the number of particles, on a motion resampled.
ExperimentCases hierarchy_sizes(bool quick, const SharedMotions& motions);

/// A scene whose motion is recorded, from shortly before cloth and ball meet.
struct HierarchyScene {
    const char* name;
    double from;  ///< [s]

    /// At about the rate of a screen.
    [[nodiscard]] MotionWanted frames(int count) const { return {name, from, 1.0 / 60, count}; }
};
inline constexpr HierarchyScene hierarchy_scenes[] = {{"drop", 0.1}, {"two_corners", 0.2}, {"curtain", 0.8}};

/// Particles along a side, and in all, of the larger cloth on which time is set against accuracy.
inline constexpr int resampled_side = 128, resampled_particles = resampled_side * resampled_side;

/// What every part with several volumes draws: spheres about centroids, as the original has them, and one of each
/// other family.
inline constexpr VolumeKind volume_families[] = {VolumeKind::Sphere, VolumeKind::Aabb, VolumeKind::Kdop18,
                                                 VolumeKind::Obb};

/// How times grow with the number of particles, for one hierarchy.
struct Growth {
    std::string volume, update;
    double build = 0, search = 0;  ///< exponents; the search is query and exact test
};

/// Fitted over the larger cloths, from the geometric middle of the smallest and the largest on, where what a call costs
/// at the least no longer counts. Hierarchies with fewer than two such sizes are left out.
/// @param rows of the part "size"
std::vector<Growth> growths(const Rows& rows);

}  // namespace drape
