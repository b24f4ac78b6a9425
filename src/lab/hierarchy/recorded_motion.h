#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "drape/model/ball.h"
#include "drape/model/grid.h"
#include "drape/sim/settings.h"

namespace drape {

/// Cloth and ball of a scene as its hierarchy meets them, frame after frame: in the place to which the integrator has
/// brought the cloth, before contact has pushed it back.
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
};

/// Simulates a scene and keeps frames of its first cloth and first ball.
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
    const RecordedMotion& find(const MotionWanted& wanted);

private:
    std::map<std::tuple<std::string, double, double, int>, RecordedMotion> recorded_;
};

}  // namespace drape
