#pragma once

#include <algorithm>
#include <limits>

#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// Three directions of length 1, each at right angles to the others, as columns.
using BoxAxes = Eigen::Matrix<Real, 3, 3>;

/// A box that is turned with the cloth: along the mean directions of the patch's rows and columns. @cite gottschalk1996
/// Coordinates along them are measured from one of its own particles, so that they are as exact as the patch is small,
/// however far out it is.
struct Obb {
    Vec3 origin = Vec3::Zero();          ///< a particle of the patch
    BoxAxes axes = BoxAxes::Identity();  ///< orthonormal, even of a patch that is a line or a point
    Vec3 low = Vec3::Zero();             ///< along the axes from the origin, grown by the rounding
    Vec3 high = Vec3::Zero();

    /// The smallest box along those directions a_k: low_k = min a_k . (x_p - origin), high_k = max a_k . (x_p -
    /// origin).
    /// @par Cost O(particles of the patch), one pass
    static Obb fit(const Patch& patch);

    /// A box without points, along the patch's directions: low and high are left empty, from infinity down to
    /// -infinity.
    static Obb start(const Patch& patch);

    /// Grows along its directions by just as much as a point needs, and the rounding.
    void include(const Vec3& p);

    /// Makes up for the rounding of coordinates along the axes.
    void grow_by_rounding();

    /// The smallest box about boxes along their mean directions. @pre one child or more
    static Obb merge(std::span<const Obb> children);

    /// By the distance of the ball's centre from the box, in the box's directions.
    [[nodiscard]] bool overlaps(const Ball& ball) const {
        constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
        const Vec3 offset = ball.centre - origin;
        Real square = 0;
        for (int k = 0; k < 3; ++k) {
            const Real along = axes(0, k) * offset[0] + axes(1, k) * offset[1] + axes(2, k) * offset[2];
            const Real beyond = std::max(Real(0), std::max(low[k] - along, along - high[k]));
            square += beyond * beyond;
        }
        const Real radius = ball.radius * (1 + 16 * epsilon) + 8 * epsilon * offset.cwiseAbs().sum();
        return square <= radius * radius;
    }

    /// By the gaps along the directions of both: those of the nine pairs of edges are left out, which cost more than
    /// they prune. @cite gottschalk1996
    [[nodiscard]] bool comes_within(const Obb& other, Real margin) const;

    /// About the middle, through the corners.
    [[nodiscard]] BoundingSphere sphere() const;
};

static_assert(BoundingVolume<Obb>);

}  // namespace drape
