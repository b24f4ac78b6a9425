#include "drape/bounds/bounding_sphere.h"

#include <algorithm>
#include <cmath>

#include "drape/base/assert.h"

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
    Vec3 sum = Vec3::Zero();
    for_each_particle(patch, [&](const Vec3& p) { sum += p; });
    const Vec3 centre = sum / static_cast<Real>(patch.particles());
    Real square = 0;
    for_each_particle(patch, [&](const Vec3& p) { square = std::max(square, (p - centre).squaredNorm()); });
    return {centre, radius_of(square)};
}

void BoundingSphere::include(const Vec3& p) {
    const Real square = (p - centre).squaredNorm();
    if (square <= radius * radius) return;
    const Real distance = std::sqrt(square), beyond = (distance - radius) / 2;
    if (!(beyond > 0)) return static_cast<void>(radius = distance * rounded_up);
    const Vec3 before = centre;
    centre += (p - centre) * (beyond / distance);

    // The centre was rounded: the radius is measured
    radius = std::max((centre - before).norm() + radius, (p - centre).norm()) * rounded_up;
}

Real BoundingSphere::radius_of(Real square) { return std::sqrt(square) * rounded_up; }

BoundingSphere BoundingSphere::merge(std::span<const BoundingSphere> children) {
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

}  // namespace drape
