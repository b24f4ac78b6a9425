#pragma once

#include <limits>
#include <span>

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

    // CPU times a frame: quartiles over frames and repeats
    double build_s = none, build_lower_s = none, build_upper_s = none;
    double query_s = none, query_lower_s = none, query_upper_s = none;
    double exact_s = none, exact_lower_s = none, exact_upper_s = none;
    double whole_s = none, whole_lower_s = none, whole_upper_s = none;  ///< build, query and exact test
    double cumulative_s = none;                                         ///< of all frames so far, medians over repeats
    double cumulative_s_over_rebuild_s = none;                          ///< the same over that of `rebuild`

    // A mean frame; the same in every run
    double nodes = none;           ///< of the whole tree, or of the level
    double visited = none;         ///< that the search reached
    double candidates = none;      ///< cells
    double touching = none;        ///< cells
    double false_per_true = none;  ///< candidates that do not touch over those that do
    double tightness = none;       ///< mean over nodes: size over that of the smallest volume of the kind
    double moved = none;           ///< part of the particles that moved farther than a refit lets pass

    // What a limited search did to the simulated motion
    double missed_penetration_m = none;  ///< largest
    double false_contacts = none;        ///< a step
    double distance_m = none;            ///< RMS of the particles from where the full search has them, at the end

    /// A row about a hierarchy on a motion.
    static HierarchyRow of(const std::string& part, const RecordedMotion& motion,
                           const BroadPhaseParameters& parameters);

    /// Fills in the times of a run.
    void set_times(const HierarchyRun& run);

    /// Fills in the means of what queries found.
    void set_counts(const std::vector<FrameCounts>& counts);

    /// Name of the volume, with the fit of a sphere that is not the original's.
    [[nodiscard]] std::string variant() const;
};

/// The columns, and which of them each part fills.
RowFormat<HierarchyRow> hierarchy_format();

}  // namespace drape
