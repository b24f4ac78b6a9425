#pragma once

#include <limits>
#include <memory>
#include <span>

#include "drape/bounds/broad_phase.h"
#include "hierarchy_run.h"
#include "lab/experiment/experiment.h"

namespace drape {

/// A line of the table. The parts of the experiment share its columns; what a part does not tell is nan.
struct HierarchyRow {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::string part;  ///< fit, level, budget, break_even or size
    std::string scene;
    std::string volume, sphere_fit, update;
    double particles = none;
    double leaf_cells = none;  ///< 0: as measured to be fastest
    double level = none;       ///< that the row is about, or at which the search ended
    double tests = none;       ///< after which the search ended
    double interval_s = none;  ///< between frames
    double frame = none;

    static constexpr Quartiles no_times{none, none, none};
    Quartiles build = no_times, query = no_times, exact = no_times;  ///< CPU times, over frames and repeats [s]
    Quartiles whole = no_times;                                      ///< build, query and exact test
    double cumulative_s = none;                                      ///< of all frames so far, medians over repeats
    double cumulative_s_over_rebuild_s = none;                       ///< the same over that of `rebuild`

    // A mean frame; the same in every run
    double nodes = none;           ///< of the whole tree, or of the level
    double visited = none;         ///< by the search
    double candidates = none;      ///< cells
    double touching = none;        ///< cells
    double false_per_true = none;  ///< candidates that do not touch over those that do
    double tightness = none;       ///< mean over nodes: size over that of the smallest volume of the kind
    double moved = none;           ///< part of the particles that moved farther than a refit lets pass

    // What a limited search did to the simulated motion
    double missed_penetration_m = none;  ///< largest
    double false_contacts = none;        ///< a step
    double distance_m = none;            ///< RMS of the particles from where the full search has them, at the end

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

// The parts of the experiment. Each gives its cases; `quick` means fewer frames, hierarchies and repeats.

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

/// The frame from which on, and to the last, one way has cost more in all than another.
/// @param costs of each frame of the way that is cheap at first
/// @param others of the other way, as many
/// @return counted from 0; nothing if it has not cost more when the last frame ends
std::optional<std::size_t> break_even_frame(std::span<const double> costs, std::span<const double> others);

/// How times grow with the number of particles, for one hierarchy.
struct Growth {
    std::string volume, update;
    PowerLaw build, search;  ///< the search is query and exact test
};

/// Fitted over the larger cloths, from the geometric middle of the smallest and the largest on, where what a call costs
/// at the least no longer counts. Hierarchies with fewer than two such sizes are left out.
/// @param rows of the part "size"
std::vector<Growth> growths(const HierarchyRows& rows);

/// The size of a node's volume, 0 for what is none.
std::size_t bytes_of_a_node(const std::string& volume);

/// A line or more a part.
std::string hierarchy_summary(const HierarchyRows& rows);

/// Charts of the parts that the rows have.
std::vector<Chart> hierarchy_charts(const HierarchyRows& rows);

}  // namespace drape
