#pragma once

#include <span>

#include "drape/base/kernels.h"
#include "drape/base/real.h"

namespace drape {

/// Of the particles of a cloth, in an order that is always the same.
struct WaySums {
    Vec3 before = Vec3::Zero();  ///< of their positions at the start [m]
    Vec3 way = Vec3::Zero();     ///< of what each has moved by since [m]
};

/// Adds up positions and ways.
/// @param before, now n x 3 [m]
[[nodiscard]] WaySums sum_ways(const Points& before, const Points& now, Kernels kernels);

/// How particles may come nearer to each other: what all move by together brings nothing nearer to anything.
struct RelativeWays {
    const Points &kept, &before, &now;  ///< some time ago, at the start of the substep and now, n x 3 [m]
    Vec3 since_kept;                    ///< what all have moved by together, from `kept` to `before` [m]
    Vec3 common;                        ///< the same from `before` to `now`, about: any will do if all have it [m]
};

/// For each particle, a least reach and its way times a factor; and with it, what the particle has strayed by since
/// some time ago.
/// @param reaches, strayed receive these [m]
/// @param allowed that each may stray [m]
/// @return whether none strays farther than it is allowed to
bool find_reaches(const RelativeWays& ways, Real least, Real factor, std::span<const Real> allowed,
                  std::span<Real> reaches, std::span<Real> strayed, Kernels kernels);

/// Whether each particle's way from `before` to `now`, and a margin [m], is within its reach.
[[nodiscard]] bool are_within(const RelativeWays& ways, Real margin, std::span<const Real> reaches, Kernels kernels);

}  // namespace drape
