#pragma once

#include "drape/model/ball.h"
#include "drape/sim/settings.h"

namespace drape {

/// The ball as it is at a time [s], at the start or on its path.
Ball make_ball(const BallSettings& settings, double time);

/// Moves a ball over one step, from `time` to `time + h`, by its kind of motion; its velocity is that of the step.
/// @param steer direction that the keys ask for, of length 0 or 1
void move_ball(const BallSettings& settings, const Vec3& steer, Real time, Real h, Ball& ball);

/// Where a path leads at a time: a smooth curve through its points. It rests at its last point, or repeats if that is
/// its first one again.
/// @pre at least two points, times ascending
Vec3 point_on_path(const std::vector<PathPoint>& path, Real time);

}  // namespace drape
