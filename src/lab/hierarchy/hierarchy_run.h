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
    double from = 0;               ///< simulated time of the first [s]
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

/// How large nodes are beside the smallest volumes of their kind about the same particles, in the mean: `tightness` of
/// all, `tightness_0` of the root, `tightness_1` of the level below ... of a hierarchy as last built. 1 is as tight as
/// can be. Sizes are radii of spheres, and the mean half width of other volumes between their pairs of faces; what a
/// tree has to be grown by, because it was not fitted again, counts. The smallest sphere is Welzl's; boxes and k-DOPs
/// that are fitted to particles are the smallest; of turned boxes only the one along the patch's mean directions is
/// known. Brute force has no nodes and no number.
/// @param x to which it was built
/// @par Cost a fit of every node, by Welzl's method for spheres
Row tightness_of(const BroadPhase& hierarchy, const Grid& grid, const Points& x);

/// What a hierarchy did in one frame, by columns of the table of `hierarchy`.
struct FrameRun {
    /// `nodes` and, of these, `visited`; `candidates`, cells, those in nodes at which a limited search has ended among
    /// them; cells `touching` the ball; where it was looked at, what `tightness_of` has.
    Row counts;
    Real slack = 0;  ///< [m]

    /// CPU times, as often as it was repeated: `build_s`; `query_s`, from the root to the candidates; `exact_s`, test
    /// of the candidates' triangles; `whole_s`, all three. None of the first frame, for whose build the tree jumps
    /// back.
    std::vector<Row> times = {};
};

struct RunPlan {
    int repeats = 3;          ///< of the whole motion, timed; one more goes before them
    int tightness_every = 0;  ///< frames it is looked at; 0: never
};

/// Takes a hierarchy along a motion: build, query and exact test in every frame. The first time each query is checked
/// against brute force; then times are taken.
/// @return a frame each
/// @throws RunError if a query does not lead to the very triangles that touch
std::vector<FrameRun> follow(const RecordedMotion& motion, BroadPhase& hierarchy, const RunPlan& plan);

/// Of a time, over frames and repeats.
Quartiles quartiles_over(std::span<const FrameRun> frames, const std::string& time);

/// Of a count, over the frames that have it; no number if none has.
double mean_over(std::span<const FrameRun> frames, const std::string& count);

}  // namespace drape
