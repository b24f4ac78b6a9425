#pragma once

#include <span>
#include <vector>

#include "drape/contact/contact.h"
#include "drape/contact/solid.h"

namespace drape {

/// The contacts of the free balls with solids, appended: at most one of each ball with each solid, where the ball is
/// deepest in it, or, if it has passed it within the substep or come to another side, where it has met it. That is
/// found by conservative advancement on the ball's way, as the solid sees it. @cite mirtich1996
/// @par Cost O(balls solids) distances
void find_ball_contacts(std::span<const Ball> balls, std::span<const Solid> solids, std::vector<BallContact>& contacts);

/// Stops a ball that nothing pushes at the surfaces of solids that it meets within the substep, and lets it slide along
/// them; back at its start, without velocity, if they leave it no room.
/// @param start of its path; what stops it may have shortened `moved` [m]
/// @param gap to leave [m]
/// @param h the substep [s]
/// @return whether it had to
bool stay_outside(std::span<const Solid> solids, const Vec3& start, Real gap, Real h, Ball& ball);

/// Whether a ball's path through the substep takes it into no solid deeper than it was at the start, or would be if it
/// stayed there, whichever is deeper.
/// @pre it has moved
/// @param gap as above [m]
[[nodiscard]] bool penetrates_no_deeper(std::span<const Solid> solids, Real gap, const Ball& ball);

}  // namespace drape
