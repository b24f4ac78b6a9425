#include "vector_fits.h"

#include <type_traits>

#include "bounds/sphere_steps.h"
#include "drape/bounds/dop_axes.h"
#include "drape/bounds/kdop.h"
#include "drape/bounds/obb.h"
#include "extent_kernels.h"
#include "extreme_kernels.h"
#include "patch_kernels.h"

namespace drape::kernels {
namespace {

Vec3 particle(const Patch& patch, ParticleIndex at) { return {patch.x[at], patch.y[at], patch.z[at]}; }

Vec3 find_farthest(const Patch& patch, const Vec3& from) { return particle(patch, farthest_particle(patch, from)); }

BoundingSphere sphere_about(const Patch& patch, const Vec3& centre) {
    Real square = 0;
    raise_to_farthest(patch, &centre, 1, &square);
    return {centre, BoundingSphere::radius_of(square)};
}

template <int lines>
LineEnds<lines> ends_of_lines(const Patch& patch) {
    LineEnds<lines> ends;
    for (int line = 0; line < lines; ++line) {
        const Extremes found = extreme_particles(patch, dop_axes[static_cast<std::size_t>(line)]);
        ends.set(2 * line, particle(patch, found.low));
        ends.set(2 * line + 1, particle(patch, found.high));
    }
    return ends;
}

}  // namespace

template <BoundingVolume Volume>
Volume fit(const Patch& patch) {
    if constexpr (std::is_same_v<Volume, Aabb>) {
        Aabb box;
        bounding_box(patch, box.low.data(), box.high.data());
        return box;
    } else if constexpr (std::is_same_v<Volume, Obb>) {
        Obb box = Obb::frame_of(patch);
        extents_along(patch, box.origin, box.axes, box.low.data(), box.high.data());
        box.grow_by_rounding();
        return box;
    } else {
        constexpr std::size_t slabs = Volume::cuts + 3;
        std::array<Real, slabs> least, most;
        dop_extents(patch, static_cast<int>(slabs), least.data(), most.data());
        return Volume::from_extents(least, most);
    }
}

template Aabb fit<Aabb>(const Patch&);
template KDop<6> fit<KDop<6>>(const Patch&);
template KDop<14> fit<KDop<14>>(const Patch&);
template KDop<18> fit<KDop<18>>(const Patch&);
template KDop<26> fit<KDop<26>>(const Patch&);
template Obb fit<Obb>(const Patch&);

BoundingSphere fit_centroid_sphere(const Patch& patch) {
    BoundingSphere sphere;
    sphere.radius = BoundingSphere::radius_of(centroid_sphere(patch, sphere.centre));
    return sphere;
}

BoundingSphere fit_box_sphere(const Patch& patch) {
    const Aabb box = fit<Aabb>(patch);
    return sphere_about(patch, (box.low + box.high) / 2);
}

BoundingSphere fit_ritter_sphere(const Patch& patch) {
    return sphere_about(patch, grown_centre(patch, sphere_about_widest(ends_of_lines<3>(patch))));
}

template <int lines>
BoundingSphere fit_epos_sphere(const Patch& patch) {
    if (patch.particles() <= 2 * lines) return fit_smallest_sphere(patch);
    const LineEnds<lines> ends = ends_of_lines<lines>(patch);
    return sphere_about(patch, grown_centre(patch, fit_smallest_sphere(ends.patch())));
}

template BoundingSphere fit_epos_sphere<3>(const Patch&);
template BoundingSphere fit_epos_sphere<7>(const Patch&);
template BoundingSphere fit_epos_sphere<13>(const Patch&);

BoundingSphere fit_smallest_sphere(const Patch& patch) {
    return sphere_about(patch, smallest_sphere_centre(patch, find_farthest));
}

}  // namespace drape::kernels
