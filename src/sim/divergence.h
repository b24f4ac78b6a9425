#pragma once

#include <span>
#include <string>

#include "drape/scene/settings.h"
#include "drape/sim/cloth.h"

namespace drape {

/// What has diverged: one clause that names the first such particle, and which that is; empty while all is well.
struct Divergence {
    std::string clause;
    int particle = -1, other = -1;  ///< `other` is at the other end of the worst of its springs
};

/// What shows that the last step has diverged: a number that is no longer finite, or particles that move against
/// one another far faster than gravity, balls, wind and hand could have made them.
/// @param sums of the cloth's state
/// @par Cost O(1) while all is well
Divergence divergence(const Cloth& cloth, const MotionSums& sums, std::span<const Ball> balls,
                      const Settings& settings);

}  // namespace drape
