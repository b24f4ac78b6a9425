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
/// them.
/// @param gap to leave [m]
/// @param h the substep [s]
/// @return whether it had to
bool stay_outside(std::span<const Solid> solids, Real gap, Real h, Ball& ball);

/// Whether a ball is on its way through the substep in no solid deeper than at its start, or than if it stayed there.
/// @param gap as above [m]
[[nodiscard]] bool penetrates_no_deeper(std::span<const Solid> solids, Real gap, const Ball& ball);

}  // namespace drape
