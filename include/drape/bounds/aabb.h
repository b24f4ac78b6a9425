#pragma once

#include <algorithm>

#include "drape/base/assert.h"
#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// A box along the axes of space.
struct Aabb {
    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Zero();

    /// The smallest box, to the bit: low = min x_p and high = max x_p, axis by axis.
    /// @par Cost O(particles of the patch), one pass
    static Aabb fit(const Patch& patch) {
        Aabb box{patch.at(0, 0), patch.at(0, 0)};
        for_each_particle(patch, [&](const Vec3& p) { box.include(p); });
        return box;
    }

    /// The first particle.
    static Aabb start(const Patch& patch) { return {patch.at(0, 0), patch.at(0, 0)}; }

    /// The smallest box about boxes, to the bit. @pre one child or more
    static Aabb merge(std::span<const Aabb> children) {
        DRAPE_ASSERT(!children.empty());
        Aabb all = children[0];
        for (const Aabb& child : children.subspan(1)) all.include(child);
        return all;
    }

    /// Grows by just as much as a point needs.
    void include(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
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
        const Real radius = ball.radius * rounded_up;
        return square <= radius * radius;
    }

    /// By the gaps along the axes.
    [[nodiscard]] bool comes_within(const Aabb& other, Real margin) const {
        const Vec3 gap = (low - other.high).cwiseMax(other.low - high).cwiseMax(Real(0));
        const Real bound = margin * rounded_up;
        return gap.squaredNorm() <= bound * bound;
    }

    /// As `comes_within` with no margin.
    [[nodiscard]] bool meets(const Aabb& other) const {
        return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y() &&
               other.low.y() <= high.y() && low.z() <= other.high.z() && other.low.z() <= high.z();
    }

    /// About the middle, through the farthest corner.
    [[nodiscard]] BoundingSphere sphere() const {
        const Vec3 middle = (low + high) / 2;
        return {middle, (high - middle).cwiseMax(middle - low).norm() * rounded_up};
    }
};

static_assert(BoundingVolume<Aabb>);

}  // namespace drape
