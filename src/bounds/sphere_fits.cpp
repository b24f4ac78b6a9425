#include "drape/bounds/sphere_fits.h"

#include <array>
#include <cmath>

#include "drape/bounds/aabb.h"
#include "drape/bounds/dop_axes.h"
#include "kernels/patch_kernels.h"
#include "smallest_sphere.h"

namespace drape {
namespace {

struct Ends {
    Vec3 low, high;
};

/// The passes over the particles, plain. Of several that are equally far out, the first counts.
struct PlainPasses {
    static Vec3 farthest(const Patch& patch, const Vec3& from) {
        Vec3 farthest = patch.at(0, 0);
        for_each_particle(patch, [&](const Vec3& p) {
            if ((p - from).squaredNorm() > (farthest - from).squaredNorm()) farthest = p;
        });
        return farthest;
    }

    static Real largest_square(const Patch& patch, const Vec3& from) {
        return (farthest(patch, from) - from).squaredNorm();
    }

    /// The particles at both ends along a line of `dop_axes`.
    static Ends ends(const Patch& patch, int line) {
        Vec3 low = patch.at(0, 0), high = low;
        for_each_particle(patch, [&](const Vec3& p) {
            if (dop_projection(line, p) < dop_projection(line, low)) low = p;
            if (dop_projection(line, p) > dop_projection(line, high)) high = p;
        });
        return {low, high};
    }

    static Ends box(const Patch& patch) {
        const Aabb box = Aabb::fit(patch);
        return {box.low, box.high};
    }

    static BoundingSphere centroid_sphere(const Patch& patch) { return BoundingSphere::fit(patch); }
};

/// The same by vector kernels.
struct VectorPasses {
    static Vec3 particle(const Patch& patch, kernels::ParticleIndex at) {
        return {patch.x[at], patch.y[at], patch.z[at]};
    }

    static Vec3 farthest(const Patch& patch, const Vec3& from) {
        return particle(patch, kernels::farthest_particle(patch, from));
    }

    static Real largest_square(const Patch& patch, const Vec3& from) {
        Real square = 0;
        kernels::raise_to_farthest(patch, &from, 1, &square);
        return square;
    }

    static Ends ends(const Patch& patch, int line) {
        const kernels::Extremes found = kernels::extreme_particles(patch, dop_axes[static_cast<std::size_t>(line)]);
        return {particle(patch, found.low), particle(patch, found.high)};
    }

    static Ends box(const Patch& patch) {
        Ends box;
        kernels::dop_extents(patch, 3, box.low.data(), box.high.data());
        return box;
    }

    static BoundingSphere centroid_sphere(const Patch& patch) {
        BoundingSphere sphere;
        sphere.radius = BoundingSphere::radius_of(kernels::centroid_sphere(patch, sphere.centre));
        return sphere;
    }
};

/// About a centre through the farthest particle.
template <class Passes>
BoundingSphere sphere_about(const Patch& patch, const Vec3& centre) {
    return {centre, BoundingSphere::radius_of(Passes::largest_square(patch, centre))};
}

/// One pass in which a sphere takes in, one after the other, the particles that stand out of it, each by as little as
/// possible: with d = |p - c| > r, c += (d - r)/2 (p - c)/d and r += (d - r)/2. @cite ritter1990
/// @return the centre of the grown sphere
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
template <class Passes>
BoundingSphere fit_box_sphere(const Patch& patch) {
    const Ends box = Passes::box(patch);
    return sphere_about<Passes>(patch, (box.low + box.high) / 2);
}

/// Ends of the axes, the widest pair, then grown. @cite ritter1990
template <class Passes>
BoundingSphere fit_ritter_sphere(const Patch& patch) {
    Ends widest = Passes::ends(patch, 0);
    for (const int line : {1, 2}) {
        const Ends ends = Passes::ends(patch, line);
        if ((ends.high - ends.low).squaredNorm() > (widest.high - widest.low).squaredNorm()) widest = ends;
    }
    const BoundingSphere first{(widest.low + widest.high) / 2, (widest.high - widest.low).norm() / 2};
    return sphere_about<Passes>(patch, grown_centre(patch, first));
}

/// In smallest_sphere.cpp. @cite welzl1991
template <class Passes>
BoundingSphere fit_welzl_sphere(const Patch& patch) {
    return sphere_about<Passes>(patch, smallest_sphere_centre(patch, Passes::farthest));
}

/// The smallest sphere about the ends of the lines, then grown. @cite larsson2008
template <class Passes, int lines>
BoundingSphere fit_epos_sphere(const Patch& patch) {
    constexpr int count = 2 * lines;
    if (patch.particles() <= count) return fit_welzl_sphere<Passes>(patch);
    Real x[count], y[count], z[count];
    for (int line = 0; line < lines; ++line) {
        const Ends ends = Passes::ends(patch, line);
        int k = 2 * line;
        for (const Vec3& p : {ends.low, ends.high}) x[k] = p[0], y[k] = p[1], z[k] = p[2], ++k;
    }
    return sphere_about<Passes>(patch, grown_centre(patch, fit_welzl_sphere<Passes>({x, y, z, count, 1, count})));
}

template <class Passes>
BoundingSphere (*fit_of(SphereFit kind))(const Patch&) {
    // In the order of the kinds
    constexpr std::array fits{Passes::centroid_sphere,    fit_box_sphere<Passes>,     fit_ritter_sphere<Passes>,
                              fit_epos_sphere<Passes, 3>, fit_epos_sphere<Passes, 7>, fit_epos_sphere<Passes, 13>,
                              fit_welzl_sphere<Passes>};
    static_assert(fits.size() == enum_names<SphereFit>.size(), "every kind has its fit");
    return fits[static_cast<std::size_t>(kind)];
}

}  // namespace

BoundingSphere (*sphere_fit_of(SphereFit kind, Kernels kernels))(const Patch&) {
    return kernels == Kernels::Plain ? fit_of<PlainPasses>(kind) : fit_of<VectorPasses>(kind);
}

BoundingSphere fit_smallest_sphere(const Patch& patch) { return fit_welzl_sphere<PlainPasses>(patch); }

}  // namespace drape
