#include "drape/bounds/sphere_fits.h"

#include <array>

#include "drape/base/assert.h"
#include "drape/bounds/aabb.h"
#include "drape/bounds/dop_axes.h"
#include "extreme_kernels.h"
#include "measured_sphere.h"
#include "smallest_sphere.h"

namespace drape {
namespace {

/// One pass in which a sphere takes in, one after the other, the particles that stand out of it, each by as little as
/// possible. @cite ritter1990
BoundingSphere grown_about(const Patch& patch, BoundingSphere sphere) {
    for (int j = 0; j < patch.rows; ++j) {
        for (int i = 0; i < patch.columns; ++i) {
            const Vec3 outward = patch.at(i, j) - sphere.centre;
            const Real square = outward.squaredNorm();
            if (square <= sphere.radius * sphere.radius) continue;
            const Real distance = std::sqrt(square), beyond = (distance - sphere.radius) / 2;
            sphere.centre += outward * (beyond / distance);
            sphere.radius += beyond;
        }
    }
    return measured_sphere(patch, sphere.centre);
}

template <int axes>
BoundingSphere fit_epos(const Patch& patch) {
    constexpr int ends = 2 * axes;
    if (patch.particles() <= ends) return fit_smallest_sphere(patch);
    std::array<Real, ends> x, y, z;
    std::size_t count = 0;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const kernels::Extremes found = kernels::extreme_particles(patch, dop_axes[axis]);
        for (const ParticleIndex at : {found.low, found.high}) {
            x[count] = patch.x[at], y[count] = patch.y[at], z[count] = patch.z[at];
            ++count;
        }
    }
    return grown_about(patch, fit_smallest_sphere({x.data(), y.data(), z.data(), ends, 1, ends}));
}

}  // namespace

BoundingSphere fit_box_sphere(const Patch& patch) {
    const Aabb box = Aabb::fit(patch);
    return measured_sphere(patch, (box.low + box.high) / 2);
}

BoundingSphere fit_ritter_sphere(const Patch& patch) {
    Vec3 low = patch.at(0, 0), high = low;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const kernels::Extremes found = kernels::extreme_particles(patch, dop_axes[axis]);
        const Vec3 a = particle(patch, found.low), b = particle(patch, found.high);
        if ((b - a).squaredNorm() > (high - low).squaredNorm()) low = a, high = b;
    }
    return grown_about(patch, {(low + high) / 2, (high - low).norm() / 2});
}

BoundingSphere fit_epos6_sphere(const Patch& patch) { return fit_epos<3>(patch); }
BoundingSphere fit_epos14_sphere(const Patch& patch) { return fit_epos<7>(patch); }
BoundingSphere fit_epos26_sphere(const Patch& patch) { return fit_epos<13>(patch); }

BoundingSphere fit_smallest_sphere(const Patch& patch) { return measured_sphere(patch, smallest_sphere_centre(patch)); }

BoundingSphere (*sphere_fit_of(SphereFit kind))(const Patch&) {
    switch (kind) {
        case SphereFit::Centroid:
            return BoundingSphere::fit;
        case SphereFit::BoxCentre:
            return fit_box_sphere;
        case SphereFit::Ritter:
            return fit_ritter_sphere;
        case SphereFit::Epos6:
            return fit_epos6_sphere;
        case SphereFit::Epos14:
            return fit_epos14_sphere;
        case SphereFit::Epos26:
            return fit_epos26_sphere;
        case SphereFit::Welzl:
            return fit_smallest_sphere;
    }
    DRAPE_ASSERT(false && "every kind has its fit");
    return nullptr;
}

}  // namespace drape
