#pragma once

#include <limits>

#include "drape/bounds/bounding_volume.h"

namespace drape {

/// A sphere about the mean of its particles: the original's fit. It is not the smallest, but costs two passes.
struct BoundingSphere {
    static constexpr std::string_view name = "sphere";

    Vec3 centre = Vec3::Zero();
    Real radius = 0;

    /// Centre: mean of the particles; radius: the largest distance to one, grown by `thickness` and by the rounding.
    /// @par Cost O(particles of the patch), two passes
    static BoundingSphere fit(const Patch& patch, Real thickness);

    /// True if the spheres have a point in common; errs towards true by the rounding of the comparison.
    [[nodiscard]] bool overlaps(const Ball& ball) const {
        const Real dx = centre[0] - ball.centre[0], dy = centre[1] - ball.centre[1], dz = centre[2] - ball.centre[2];
        const Real reach = (radius + ball.radius) * (1 + 8 * std::numeric_limits<Real>::epsilon());
        return dx * dx + dy * dy + dz * dz <= reach * reach;
    }

    [[nodiscard]] Placement placement() const { return {centre, Eigen::Matrix<Real, 3, 3>::Identity() * radius}; }
};

static_assert(BoundingVolume<BoundingSphere>);

}  // namespace drape
