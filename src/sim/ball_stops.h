#pragma once

#include <span>

#include "drape/model/ball.h"
#include "drape/sim/cloth.h"

namespace drape {

// What stops a ball under the keys, which nothing pushes, besides ground and solids. It may slide along, and go back.

/// Stops a ball at all cloth that touched it in the substep before and is stretched well beyond its limit, be it
/// between pins, in the hand, or under the ball.
/// @param number of the ball
/// @param h the substep, in which the ball has moved [s]
/// @par Cost one pass over the springs of each cloth that touches it and has a limit
void stop_at_taut_cloth(std::span<const Cloth> cloths, int number, Real h, Ball& ball);

/// Stops a ball at pinned particles. One that is in it already may come no nearer to its centre.
/// @param gap to leave [m]
/// @param h the substep, in which the ball has moved [s]
/// @par Cost O(particles)
void stop_at_pins(std::span<const Cloth> cloths, Real gap, Real h, Ball& ball);

}  // namespace drape
