#pragma once

#include <algorithm>
#include <limits>

#include "drape/base/real.h"

namespace drape {

/// A ball whose centre moves evenly along a line within one step.
struct SweptBall {
    Vec3 start = Vec3::Zero();  ///< its centre at the step's beginning [m]
    Vec3 end = Vec3::Zero();    ///< and at its end [m]
    Real radius = Real(0.3);    ///< grown by the cloth's thickness [m]

    /// What the rounding of the exact test may come to, by which the tests of volumes err towards true.
    /// @param farthest coordinate of what the ball may meet [m]
    [[nodiscard]] Real rounding(Real farthest) const {
        const Real size = std::max(start.cwiseAbs().maxCoeff(), end.cwiseAbs().maxCoeff()) + radius + farthest;
        return 64 * std::numeric_limits<Real>::epsilon() * size;
    }
};

/// The part of a line on which a point is within slabs: what each leaves is cut off at both ends.
struct SlabClip {
    Real begin = 0, end = 1;  ///< in parts of the line

    /// @param first, last where the line begins and ends across the slab
    /// @return false if no part is left
    bool cut(Real first, Real last, Real low, Real high) {
        if (std::max(first, last) < low || std::min(first, last) > high) return false;
        const auto at = [&](Real bound) { return (bound - first) / (last - first); };
        if (first < low) begin = std::max(begin, at(low));
        if (first > high) begin = std::max(begin, at(high));
        if (last < low) end = std::min(end, at(low));
        if (last > high) end = std::min(end, at(high));
        return begin <= end;
    }
};

}  // namespace drape
