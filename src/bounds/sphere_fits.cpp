#include "drape/bounds/sphere_fits.h"

#include <cmath>

#include "drape/bounds/aabb.h"
#include "drape/bounds/dop_axes.h"
#include "sphere_steps.h"

namespace drape {
namespace {

Vec3 farthest_particle(const Patch& patch, const Vec3& from) {
    Vec3 farthest = patch.at(0, 0);
    for_each_particle(patch, [&](const Vec3& p) {
        if ((p - from).squaredNorm() > (farthest - from).squaredNorm()) farthest = p;
    });
    return farthest;
}

/// About a centre through the farthest particle.
BoundingSphere sphere_about(const Patch& patch, const Vec3& centre) {
    return {centre, BoundingSphere::radius_of((farthest_particle(patch, centre) - centre).squaredNorm())};
}

/// The ends of the first lines of `dop_axes`.
template <int lines>
LineEnds<lines> ends_of_lines(const Patch& patch) {
    LineEnds<lines> ends;
    for (int line = 0; line < lines; ++line) {
        Vec3 low = patch.at(0, 0), high = low;
        for_each_particle(patch, [&](const Vec3& p) {
            if (dop_projection(line, p) < dop_projection(line, low)) low = p;
            if (dop_projection(line, p) > dop_projection(line, high)) high = p;
        });
        ends.set(2 * line, low);
        ends.set(2 * line + 1, high);
    }
    return ends;
}

/// The smallest sphere about the ends of the lines, then grown. @cite larsson2008
template <int lines>
BoundingSphere fit_epos_sphere(const Patch& patch) {
    if (patch.particles() <= 2 * lines) return fit_smallest_sphere(patch);
    const LineEnds<lines> ends = ends_of_lines<lines>(patch);
    return sphere_about(patch, grown_centre(patch, fit_smallest_sphere(ends.patch())));
}

}  // namespace

BoundingSphere sphere_about_widest(const LineEnds<3>& ends) {
    Vec3 low(ends.x[0], ends.y[0], ends.z[0]), high = low;
    for (int line = 0; line < 3; ++line) {
        const Vec3 a = ends.patch().at(2 * line, 0), b = ends.patch().at(2 * line + 1, 0);
        if ((b - a).squaredNorm() > (high - low).squaredNorm()) low = a, high = b;
    }
    return {(low + high) / 2, (high - low).norm() / 2};
}

Vec3 grown_centre(const Patch& patch, BoundingSphere sphere) {
    for_each_particle(patch, [&](const Vec3& p) {
        const Vec3 outward = p - sphere.centre;
        const Real square = outward.squaredNorm();
        if (square <= sphere.radius * sphere.radius) return;
        const Real distance = std::sqrt(square), beyond = (distance - sphere.radius) / 2;
        sphere.centre += outward * (beyond / distance);
        sphere.radius += beyond;
    });
    return sphere.centre;
}

/// c = (min x_p + max x_p) / 2
BoundingSphere fit_box_sphere(const Patch& patch) {
    const Aabb box = Aabb::fit(patch);
    return sphere_about(patch, (box.low + box.high) / 2);
}

/// Ends of the axes, the widest pair, then grown. @cite ritter1990
BoundingSphere fit_ritter_sphere(const Patch& patch) {
    return sphere_about(patch, grown_centre(patch, sphere_about_widest(ends_of_lines<3>(patch))));
}

BoundingSphere fit_epos6_sphere(const Patch& patch) { return fit_epos_sphere<3>(patch); }
BoundingSphere fit_epos14_sphere(const Patch& patch) { return fit_epos_sphere<7>(patch); }
BoundingSphere fit_epos26_sphere(const Patch& patch) { return fit_epos_sphere<13>(patch); }

/// In smallest_sphere.cpp. @cite welzl1991
BoundingSphere fit_smallest_sphere(const Patch& patch) {
    return sphere_about(patch, smallest_sphere_centre(patch, farthest_particle));
}

}  // namespace drape
