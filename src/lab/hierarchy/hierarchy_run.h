#pragma once

#include <vector>

#include "drape/bounds/broad_phase.h"
#include "lab/measure/timing.h"
#include "recorded_motion.h"
#include "tightness.h"

namespace drape {

/// CPU times of one frame [s].
struct FrameTimes {
    double build = 0;
    double query = 0;  ///< from the root to the candidates
    double exact = 0;  ///< test of the candidates' triangles

    [[nodiscard]] double whole() const { return build + query + exact; }
};

/// What one frame's query found.
struct FrameCounts {
    TraversalStats traversal;
    std::int64_t candidates = 0;  ///< cells, those in nodes at which a limited search has ended among them
    std::int64_t touching = 0;    ///< cells that touch the ball
};

/// What a hierarchy did along a motion.
struct HierarchyRun {
    std::vector<std::vector<FrameTimes>> times;  ///< of each frame, as often as it was repeated
    std::vector<FrameCounts> counts;             ///< of each frame
    std::vector<Tightness> tightness;            ///< of each level, over the frames that were looked at
    std::vector<Tightness> frame_tightness;      ///< of each frame; without nodes where it was not looked at
    std::vector<Real> slack;                     ///< of each frame [m]
};

struct RunPlan {
    int repeats = 3;          ///< of the whole motion, timed; one more goes before them
    int tightness_every = 0;  ///< frames; 0: never
};

/// Takes a hierarchy along a motion: build, query and exact test in every frame. The first time each query is checked
/// against brute force; then times are taken, the first frame's build left out, because the tree jumps back for it.
/// @throws RunError if a query does not lead to the very triangles that touch
HierarchyRun follow(const RecordedMotion& motion, BroadPhase& hierarchy, const RunPlan& plan);

/// Over frames and repeats, but for the first frame.
Quartiles quartiles_over_frames(const HierarchyRun& run, double (*time)(const FrameTimes&));

/// Candidates that do not touch over those that do, over all frames.
double false_per_true(const std::vector<FrameCounts>& counts);

}  // namespace drape
