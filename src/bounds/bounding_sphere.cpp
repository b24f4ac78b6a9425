#include "drape/bounds/bounding_sphere.h"

#include <cmath>

#include "drape/base/assert.h"
#include "patch_kernels.h"

namespace drape {
namespace {

/// Makes up for the rounding of a distance and of its use.
constexpr Real rounded_up = 1 + 8 * std::numeric_limits<Real>::epsilon();

/// The smallest sphere about two.
BoundingSphere about(const BoundingSphere& a, const BoundingSphere& b) {
    const Vec3 between = b.centre - a.centre;
    const Real distance = between.norm();
    if (distance + b.radius <= a.radius) return a;
    if (distance + a.radius <= b.radius) return b;
    const Real radius = (distance + a.radius + b.radius) / 2;
    const Vec3 centre = a.centre + between * ((radius - a.radius) / distance);
    return {centre, radius};
}

}  // namespace

BoundingSphere BoundingSphere::fit(const Patch& patch) {
    BoundingSphere sphere;
    sphere.radius = radius_of(kernels::centroid_sphere(patch, sphere.centre));
    return sphere;
}

Real BoundingSphere::radius_of(Real square) { return std::sqrt(square) * rounded_up; }

BoundingSphere BoundingSphere::merge(std::span<const BoundingSphere> parts) {
    DRAPE_ASSERT(!parts.empty());
    // The two that are farthest apart, from end to end
    BoundingSphere all = parts[0];
    Real widest = -1;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t k = i + 1; k < parts.size(); ++k) {
            const Real width = (parts[i].centre - parts[k].centre).norm() + parts[i].radius + parts[k].radius;
            if (width > widest) widest = width, all = about(parts[i], parts[k]);
        }
    }
    for (const BoundingSphere& part : parts) all = about(all, part);

    // The centres were rounded: the radius is measured once more
    for (const BoundingSphere& part : parts) {
        const Real reach = ((part.centre - all.centre).norm() + part.radius) * rounded_up;
        all.radius = all.radius < reach ? reach : all.radius;
    }
    return all;
}

}  // namespace drape
