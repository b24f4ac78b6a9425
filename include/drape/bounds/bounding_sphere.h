#pragma once

#include <limits>

#include "drape/bounds/bounding_volume.h"

namespace drape {

/// A sphere about particles. Its own fit is that of the dissertation, about their mean; `sphere_fits.h` has the others.
struct BoundingSphere {
    Vec3 centre = Vec3::Zero();
    Real radius = 0;

    /// About the mean of the particles: c = 1/n sum x_p, r = max |x_p - c|. @cite dissertation
    /// @par Cost O(particles of the patch), two passes
    static BoundingSphere fit(const Patch& patch);

    /// A sphere about spheres: the smallest about the two that are farthest apart, grown by what else stands out.
    /// @pre one child or more
    static BoundingSphere merge(std::span<const BoundingSphere> children);

    /// The first particle.
    static BoundingSphere start(const Patch& patch) { return {patch.at(0, 0), 0}; }

    /// Grows to the smallest sphere about itself and a point. @cite ritter1990
    void include(const Vec3& p);

    /// The radius for a largest squared distance, with what its rounding and the rounding of its use need.
    static Real radius_of(Real square);

    [[nodiscard]] bool overlaps(const Ball& ball) const {
        const Real dx = centre[0] - ball.centre[0], dy = centre[1] - ball.centre[1], dz = centre[2] - ball.centre[2];
        const Real radii = (radius + ball.radius) * (1 + 8 * std::numeric_limits<Real>::epsilon());
        return dx * dx + dy * dy + dz * dz <= radii * radii;
    }

    /// By the distance of the centres.
    [[nodiscard]] bool comes_within(const BoundingSphere& other, Real margin) const {
        constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
        const Real rounding = 4 * epsilon * (centre.cwiseAbs() + other.centre.cwiseAbs()).sum();
        const Real radii = (radius + other.radius + margin) * (1 + 8 * epsilon) + rounding;
        return (centre - other.centre).squaredNorm() <= radii * radii;
    }

    [[nodiscard]] BoundingSphere sphere() const { return *this; }
};

static_assert(BoundingVolume<BoundingSphere>);

}  // namespace drape
