#pragma once

#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/model/ball.h"
#include "drape/model/grid.h"
#include "drape/scene/settings.h"
#include "lab/measure/statistics.h"

namespace drape {

/// Cloth and ball of a scene as its hierarchy meets them, frame after frame: where the integrator has brought the
/// cloth, before contact has pushed it back.
struct RecordedMotion {
    std::string scene;
    Grid grid;
    double interval = 0;      ///< between frames [s]
    std::vector<Points> x;    ///< a frame each [m]
    std::vector<Ball> balls;  ///< a frame each, grown by the cloth's thickness
};

/// Which frames of a scene are wanted.
struct MotionWanted {
    std::string scene;
    double from = 0;      ///< simulated time of the first frame [s]
    double interval = 0;  ///< from frame to frame [s]; the nearest whole number of the scene's steps, at least one
    int frames = 1;
    int side = 0;  ///< particles along each side, to which it is resampled; 0: as the scene has them
};

/// Simulates a scene and keeps frames of its first cloth and first ball, as they are in the scene.
/// @pre the scene has a ball
/// @throws RunError if the scene diverges on the way
RecordedMotion record_motion(const MotionWanted& wanted);

/// The same under other settings than the scene's own.
RecordedMotion record_motion(const MotionWanted& wanted, Settings settings);

/// The same surfaces under another number of particles, bilinearly between those that there are.
RecordedMotion resampled(const RecordedMotion& motion, const Grid& grid);

/// Keeps what was recorded, for whoever wants the same again.
class Motions {
public:
    RecordedMotion find(const MotionWanted& wanted);

private:
    std::map<std::tuple<std::string, double, double, int>, RecordedMotion> recorded_;
};

/// How large nodes are beside the smallest volumes of their kind about the same particles: 1 is as tight as can be.
/// Sizes are radii of spheres, and the mean half width of other volumes between their pairs of faces; what a tree has
/// to be grown by, because it was not fitted again, counts. The smallest sphere is Welzl's; boxes and k-DOPs that are
/// fitted to particles are the smallest; of turned boxes only the one along the patch's mean directions is known.
struct Tightness {
    double sum = 0;  ///< of the ratios
    std::int64_t nodes = 0;

    [[nodiscard]] double mean() const { return sum / static_cast<double>(nodes); }
    Tightness& operator+=(const Tightness& other);
};

/// Adds the nodes of a hierarchy, as last built, to the sums of their levels. Nothing for brute force.
/// @param x to which it was built
/// @param levels grows to as many as there are
/// @par Cost a fit of every node, by Welzl's method for spheres
void add_tightness(const BroadPhase& hierarchy, const Grid& grid, const Points& x, std::vector<Tightness>& levels);

/// All levels together.
Tightness over_levels(const std::vector<Tightness>& levels);

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
/// @param time a member of `FrameTimes`
template <class Time>
Quartiles quartiles_over_frames(const HierarchyRun& run, Time time) {
    std::vector<double> times;
    for (std::size_t k = 1; k < run.times.size(); ++k) {
        for (const FrameTimes& frame : run.times[k]) times.push_back(std::invoke(time, frame));
    }
    return quartiles_of(std::move(times));
}

/// @param count a member of `FrameCounts`, or a function of it
template <class Count>
double mean_over_frames(const std::vector<FrameCounts>& counts, Count count) {
    double sum = 0;
    for (const FrameCounts& one : counts) sum += static_cast<double>(std::invoke(count, one));
    return sum / static_cast<double>(counts.size());
}

/// Candidates that do not touch over those that do, over all frames.
double false_per_true(const std::vector<FrameCounts>& counts);

}  // namespace drape
