#pragma once

#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/model/ball.h"
#include "drape/model/grid.h"
#include "drape/scene/settings.h"
#include "lab/experiment/experiment.h"

namespace drape {

/// Cloth and ball of a scene as its hierarchy meets them, frame after frame: where the integrator has brought the
/// cloth, before contact has pushed it back.
struct RecordedMotion {
    std::string scene;
    Grid grid;
    double interval = 0;           ///< between frames [s]
    std::vector<Points> x = {};    ///< a frame each [m]
    std::vector<Ball> balls = {};  ///< a frame each, grown by the cloth's thickness
};

/// Which frames of a scene are wanted.
struct MotionWanted {
    std::string scene;
    double from = 0;      ///< simulated time of the first frame [s]
    double interval = 0;  ///< from frame to frame [s]; the nearest whole number of the scene's steps, at least one
    int frames = 1;
    int side = 0;  ///< particles along each side, to which `find_motion` resamples it; 0: as the scene has them
};

/// Recorded motions, by what was wanted but for the side.
using Motions = std::map<std::tuple<std::string, double, double, int>, RecordedMotion>;

/// Simulates a scene and keeps frames of its first cloth and first ball, as they are under the settings.
/// @pre the scene has a ball
/// @throws RunError if the scene diverges on the way
RecordedMotion record_motion(const MotionWanted& wanted, Settings settings);

/// The same under the scene's own settings, or the same surfaces under another number of particles, bilinearly between
/// those that there are.
/// @param motions keeps what is recorded, for whoever wants these frames again
RecordedMotion find_motion(Motions& motions, const MotionWanted& wanted);

/// How large nodes are beside the smallest volumes of their kind about the same particles: 1 is as tight as can be.
/// Sizes are radii of spheres, and the mean half width of other volumes between their pairs of faces; what a tree has
/// to be grown by, because it was not fitted again, counts. The smallest sphere is Welzl's; boxes and k-DOPs that are
/// fitted to particles are the smallest; of turned boxes only the one along the patch's mean directions is known.
struct Tightness {
    double sum = 0;  ///< of the ratios
    std::int64_t nodes = 0;

    /// @return no number without nodes
    [[nodiscard]] double mean() const { return nodes > 0 ? sum / static_cast<double>(nodes) : no_number; }
    void operator+=(const Tightness& other) { sum += other.sum, nodes += other.nodes; }
};

/// That of each level of a hierarchy, as last built. Brute force has no levels.
/// @param x to which it was built
/// @par Cost a fit of every node, by Welzl's method for spheres
std::vector<Tightness> tightness_of(const BroadPhase& hierarchy, const Grid& grid, const Points& x);

/// All levels together.
Tightness over_levels(const std::vector<Tightness>& levels);

/// What a hierarchy did in one frame, by columns of the table of `hierarchy`.
struct FrameRun {
    /// `nodes` and, of these, `visited`; `candidates`, cells, those in nodes at which a limited search has ended among
    /// them; cells `touching` the ball.
    Row counts;
    Real slack = 0;            ///< [m]
    Tightness tightness = {};  ///< without nodes where it was not looked at

    /// CPU times, as often as it was repeated: `build_s`; `query_s`, from the root to the candidates; `exact_s`, test
    /// of the candidates' triangles; `whole_s`, all three.
    std::vector<Row> times = {};
};

/// What a hierarchy did along a motion.
struct HierarchyRun {
    std::vector<FrameRun> frames;
    std::vector<Tightness> levels;  ///< of each, over the frames in which it was looked at

    /// All frames but the first, for whose build the tree jumps back.
    [[nodiscard]] std::span<const FrameRun> timed() const { return std::span(frames).subspan(1); }
};

struct RunPlan {
    int repeats = 3;          ///< of the whole motion, timed; one more goes before them
    int tightness_every = 0;  ///< frames; 0: never
};

/// Takes a hierarchy along a motion: build, query and exact test in every frame. The first time each query is checked
/// against brute force; then times are taken.
/// @throws RunError if a query does not lead to the very triangles that touch
HierarchyRun follow(const RecordedMotion& motion, BroadPhase& hierarchy, const RunPlan& plan);

/// Of a time, over frames and repeats.
Quartiles quartiles_over(std::span<const FrameRun> frames, const std::string& time);

/// Of a count.
double sum_over(std::span<const FrameRun> frames, const std::string& count);

}  // namespace drape
