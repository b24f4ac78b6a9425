#pragma once

#include <memory>

#include "drape/bounds/broad_phase.h"
#include "hierarchy_row.h"

namespace drape {

// The parts of the hierarchy's experiment. Each gives its cases; `quick` means fewer frames, hierarchies and repeats.

using HierarchyCase = CaseOf<HierarchyRow>;

/// What the cases record is kept for the others of the same program.
using SharedMotions = std::shared_ptr<Motions>;

/// Time a frame against false candidates, nodes visited and tightness: volume, sphere fit, update and leaf size on
/// three scenes.
std::vector<HierarchyCase> fit_cases(bool quick, const SharedMotions& motions);

/// The same level by level: what a search knows that ends at a level, and what it has cost.
std::vector<HierarchyCase> level_cases(bool quick, const SharedMotions& motions);

/// What a search with a budget lets through and invents while the scene is simulated with it.
std::vector<HierarchyCase> budget_cases(bool quick, const SharedMotions& motions);

/// What the updates have cost in all, frame by frame, at several intervals between frames.
std::vector<HierarchyCase> break_even_cases(bool quick, const SharedMotions& motions);

/// Cost against the number of particles, on a motion resampled.
std::vector<HierarchyCase> size_cases(bool quick, const SharedMotions& motions);

/// The scenes whose motions are recorded, from shortly before cloth and ball meet.
struct HierarchyScene {
    const char* name;
    double from;  ///< [s]
};
inline constexpr HierarchyScene hierarchy_scenes[] = {{"drop", 0.1}, {"two_corners", 0.2}, {"curtain", 0.8}};

/// The frames of a scene at about the rate of a screen.
MotionWanted screen_frames(const HierarchyScene& scene, int frames);

/// Particles of the larger cloth to which the motions are resampled where time is set against accuracy.
inline constexpr int resampled_side = 128;
inline constexpr int resampled_particles = resampled_side * resampled_side;

/// What every part with several volumes draws: the original's spheres, and one of each other family.
struct VolumeVariant {
    VolumeKind volume;
    SphereFit fit = SphereFit::Centroid;
};
inline constexpr VolumeVariant volume_families[] = {
    {VolumeKind::Sphere}, {VolumeKind::Aabb}, {VolumeKind::Kdop18}, {VolumeKind::Obb}};

inline constexpr UpdateKind all_updates[] = {UpdateKind::Rebuild, UpdateKind::Merge, UpdateKind::Refit,
                                             UpdateKind::None};

}  // namespace drape
