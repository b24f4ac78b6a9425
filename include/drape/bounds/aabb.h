#pragma once

#include <algorithm>
#include <limits>

#include "drape/base/assert.h"
#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// A box along the axes of space.
struct Aabb {
    static constexpr std::string_view name = "aabb";

    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Zero();

    /// The smallest box, to the bit.
    /// @par Cost O(particles of the patch), one pass
    static Aabb fit(const Patch& patch);

    /// The smallest box about boxes, to the bit. @pre one part or more
    static Aabb merge(std::span<const Aabb> parts) {
        DRAPE_ASSERT(!parts.empty());
        Aabb all = parts[0];
        for (const Aabb& part : parts.subspan(1)) all.include(part);
        return all;
    }

    /// Grows by just as much as another box needs.
    void include(const Aabb& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }

    /// By the distance of the ball's centre from the box. @cite arvo1990
    [[nodiscard]] bool overlaps(const Ball& ball) const {
        Real square = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const Real below = low[axis] - ball.centre[axis], above = ball.centre[axis] - high[axis];
            const Real beyond = std::max(Real(0), std::max(below, above));
            square += beyond * beyond;
        }
        const Real reach = ball.radius * (1 + 8 * std::numeric_limits<Real>::epsilon());
        return square <= reach * reach;
    }

    /// About the middle, through the farthest corner.
    [[nodiscard]] BoundingSphere sphere() const {
        const Vec3 middle = (low + high) / 2;
        const Real radius = (high - middle).cwiseMax(middle - low).norm();
        return {middle, radius * (1 + 8 * std::numeric_limits<Real>::epsilon())};
    }

    void outline(NodeState state, Outlines& outlines) const {
        append_box({Vec3::Zero(), BoxAxes::Identity(), low, high}, state, outlines);
    }
};

static_assert(BoundingVolume<Aabb>);

}  // namespace drape
