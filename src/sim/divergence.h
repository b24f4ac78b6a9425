#pragma once

#include <span>
#include <string>

#include "drape/sim/cloth.h"
#include "drape/sim/settings.h"

namespace drape {

/// What shows that the last step has diverged: a number that is no longer finite, or particles that move against
/// one another far faster than gravity, balls, wind and hand could have made them.
/// @param sums of the cloth's state
/// @return one clause that names the first such particle; empty while all is well
/// @par Cost O(1) while all is well
std::string divergence(const Cloth& cloth, const MotionSums& sums, std::span<const Ball> balls,
                       const Settings& settings);

}  // namespace drape
