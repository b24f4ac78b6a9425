#pragma once

#include "drape/bounds/broad_phase.h"
#include "hierarchy_run.h"
#include "lab/experiment/experiment.h"

namespace drape {

/// A line of the table. The parts of the experiment share its columns; what a part does not tell is nan.
struct HierarchyRow {
    std::string part;  ///< fit, level, budget, break_even or size
    std::string scene;
    std::string volume, sphere_fit, update;
    double particles = no_number;
    double leaf_cells = no_number;  ///< 0: as measured to be fastest
    double level = no_number;       ///< that the row is about, or at which the search ended
    double tests = no_number;       ///< after which the search ended
    double interval_s = no_number;  ///< between frames
    double frame = no_number;

    Quartiles build = no_quartiles, query = no_quartiles,
              exact = no_quartiles;                  ///< CPU times, over frames and repeats [s]
    Quartiles whole = no_quartiles;                  ///< build, query and exact test
    double cumulative_s = no_number;                 ///< of all frames so far, medians over repeats
    double cumulative_s_over_rebuild_s = no_number;  ///< the same over that of `rebuild`

    // A mean frame; the same in every run
    double nodes = no_number;           ///< of the whole tree, or of the level
    double visited = no_number;         ///< by the search
    double candidates = no_number;      ///< cells
    double touching = no_number;        ///< cells
    double false_per_true = no_number;  ///< candidates that do not touch over those that do
    double tightness = no_number;       ///< mean over nodes: size over that of the smallest volume of the kind
    double moved = no_number;           ///< part of the particles that moved farther than a refit lets pass

    // What a limited search did to the simulated motion
    double missed_penetration_m = no_number;  ///< largest
    double false_contacts = no_number;        ///< a step
    double distance_m = no_number;            ///< RMS of the particles from where the full search has them, at the end

    /// A row about a hierarchy on some frames of a motion.
    static HierarchyRow of(const std::string& part, const RecordedMotion& motion,
                           const BroadPhaseParameters& parameters, const std::vector<FrameCounts>& counts);

    /// Fills in the times of a run.
    void set_times(const HierarchyRun& run);

    /// Name of the volume, with the fit of a sphere that is not by the centroid.
    [[nodiscard]] std::string variant() const;
};

using HierarchyRows = std::vector<HierarchyRow>;

/// The columns, and which of them each part fills.
RowFormat<HierarchyRow> hierarchy_format();

/// The cases of all parts; `quick` means fewer frames, hierarchies and repeats.
std::vector<CaseOf<HierarchyRow>> hierarchy_cases(bool quick);

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
std::vector<Growth> growths(const HierarchyRows& rows);

/// Charts of the parts that the rows have.
std::vector<Chart> hierarchy_charts(const HierarchyRows& rows);

}  // namespace drape
