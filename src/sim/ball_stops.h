#pragma once

#include <span>

#include "drape/contact/body.h"
#include "drape/sim/cloth.h"

namespace drape {

/// What can stop a ball under the keys, which nothing pushes.
struct BallStops {
    std::span<const Cloth> cloths;
    std::span<const ContactRow> rows;  ///< contacts of the substep before
    std::span<const Body> bodies;      ///< solids, and the ground if it is solid
    Real thickness;                    ///< of the cloth: a pin has it, and bodies leave room for two [m]
};

/// Stops a ball within the substep. It may slide along what stops it, and go back.
/// - Cloth stops it while a spring where they touch is well beyond the cloth's stretch limit: pins, the hand, or what
///   presses from the other side then leave it no more to give. Cloth without a limit always gives way.
/// - So does a pinned particle, unless it is in the hand, which gives way; one that is inside the ball already may come
///   no nearer to its centre. Where the ball is at the end of the substep counts, not what it has passed.
/// - So do ground and solids.
///
/// A ball that cannot get out of all of these stays where it was, unless the keys lead it where it penetrates none of
/// them more deeply. A ball at rest gives way to solids that move into it, if the ground leaves it room; cloth and pins
/// do not stop it then.
/// @param number of the ball, which has moved within the substep
/// @par Cost O(particles) where the ball moves
void stop_ball(const BallStops& stops, int number, Ball& ball);

}  // namespace drape
