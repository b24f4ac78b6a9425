#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/base/assert.h"
#include "drape/bounds/bounding_volume.h"

namespace drape {

/// A sphere about particles. Its own fit is that of the dissertation, about their mean; `sphere_fits.h` has the others.
struct BoundingSphere {
    Vec3 centre = Vec3::Zero();
    Real radius = 0;

    /// About the mean of the particles: c = 1/n sum x_p, r = max |x_p - c|. @cite dissertation
    /// @par Cost O(particles of the patch), two passes
    static BoundingSphere fit(const Patch& patch) {
        Vec3 sum = Vec3::Zero();
        for_each_particle(patch, [&](const Vec3& p) { sum += p; });
        const Vec3 centre = sum / static_cast<Real>(patch.particles());
        Real square = 0;
        for_each_particle(patch, [&](const Vec3& p) { square = std::max(square, (p - centre).squaredNorm()); });
        return {centre, radius_of(square)};
    }

    /// A sphere about spheres: the smallest about the two that are farthest apart, grown by what else stands out.
    /// @pre one child or more
    static BoundingSphere merge(std::span<const BoundingSphere> children) {
        DRAPE_ASSERT(!children.empty());
        // The two that are farthest apart, from end to end
        BoundingSphere all = children[0];
        Real widest = -1;
        for (std::size_t i = 0; i < children.size(); ++i) {
            for (std::size_t k = i + 1; k < children.size(); ++k) {
                const BoundingSphere &a = children[i], &b = children[k];
                const Real width = (a.centre - b.centre).norm() + a.radius + b.radius;
                if (width > widest) widest = width, all = about(a, b);
            }
        }
        for (const BoundingSphere& child : children) all = about(all, child);

        // The centres were rounded: the radius is measured once more
        for (const BoundingSphere& child : children) {
            const Real radius = ((child.centre - all.centre).norm() + child.radius) * rounded_up;
            all.radius = all.radius < radius ? radius : all.radius;
        }
        return all;
    }

    /// The smallest about two.
    static BoundingSphere about(const BoundingSphere& a, const BoundingSphere& b) {
        const Vec3 between = b.centre - a.centre;
        const Real distance = between.norm();
        if (distance + b.radius <= a.radius) return a;
        if (distance + a.radius <= b.radius) return b;
        const Real radius = (distance + a.radius + b.radius) / 2;
        const Vec3 centre = a.centre + between * ((radius - a.radius) / distance);
        return {centre, radius};
    }

    /// The first particle.
    static BoundingSphere start(const Patch& patch) { return {patch.at(0, 0), 0}; }

    /// Grows to the smallest sphere about itself and a point: with d = |p - c| > r, c += (d - r)/2 (p - c)/d and
    /// r += (d - r)/2. @cite ritter1990
    void include(const Vec3& p) {
        const Real square = (p - centre).squaredNorm();
        if (square <= radius * radius) return;
        const Real distance = std::sqrt(square), beyond = (distance - radius) / 2;
        if (!(beyond > 0)) return static_cast<void>(radius = distance * rounded_up);
        const Vec3 before = centre;
        centre += (p - centre) * (beyond / distance);

        // The centre was rounded: the radius is measured
        radius = std::max((centre - before).norm() + radius, (p - centre).norm()) * rounded_up;
    }

    /// The radius for a largest squared distance, with what its rounding and the rounding of its use need.
    static Real radius_of(Real square) { return std::sqrt(square) * rounded_up; }

    [[nodiscard]] bool overlaps(const Ball& ball) const {
        const Real dx = centre[0] - ball.centre[0], dy = centre[1] - ball.centre[1], dz = centre[2] - ball.centre[2];
        const Real radii = (radius + ball.radius) * rounded_up;
        return dx * dx + dy * dy + dz * dz <= radii * radii;
    }

    /// By the distance of the centres.
    [[nodiscard]] bool comes_within(const BoundingSphere& other, Real margin) const {
        constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
        const Real rounding = 4 * epsilon * (centre.cwiseAbs() + other.centre.cwiseAbs()).sum();
        const Real radii = (radius + other.radius + margin) * rounded_up + rounding;
        return (centre - other.centre).squaredNorm() <= radii * radii;
    }

    [[nodiscard]] BoundingSphere sphere() const { return *this; }
};

static_assert(BoundingVolume<BoundingSphere>);

}  // namespace drape
