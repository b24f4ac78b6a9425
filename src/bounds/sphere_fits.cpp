#include "drape/bounds/sphere_fits.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "drape/bounds/aabb.h"
#include "drape/bounds/dop_axes.h"
#include "kernels/patch_kernels.h"

namespace drape {
namespace {

/// Of several particles that are equally far out, the first counts.
Vec3 farthest_particle(const Patch& patch, const Vec3& from) {
    Vec3 farthest = patch.at(0, 0);
    for_each_particle(patch, [&](const Vec3& p) {
        if ((p - from).squaredNorm() > (farthest - from).squaredNorm()) farthest = p;
    });
    return farthest;
}

/// The particles at both ends along a line of `dop_axes`; the first counts here too.
std::array<Vec3, 2> ends_along(const Patch& patch, int line) {
    Vec3 low = patch.at(0, 0), high = low;
    for_each_particle(patch, [&](const Vec3& p) {
        if (dop_projection(line, p) < dop_projection(line, low)) low = p;
        if (dop_projection(line, p) > dop_projection(line, high)) high = p;
    });
    return {low, high};
}

/// About a centre through the farthest particle.
BoundingSphere sphere_about(const Patch& patch, const Vec3& centre) {
    return {centre, BoundingSphere::radius_of((farthest_particle(patch, centre) - centre).squaredNorm())};
}

/// About the centre of a sphere that has taken in, one after the other, the particles that stand out of it.
/// @cite ritter1990
BoundingSphere sphere_grown_from(BoundingSphere sphere, const Patch& patch) {
    for_each_particle(patch, [&](const Vec3& p) { sphere.include(p); });
    return sphere_about(patch, sphere.centre);
}

/// c = (min x_p + max x_p) / 2
BoundingSphere fit_box_sphere(const Patch& patch) {
    const Aabb box = Aabb::fit(patch);
    return sphere_about(patch, (box.low + box.high) / 2);
}

/// Ends of the axes, the widest pair, then grown. @cite ritter1990
BoundingSphere fit_ritter_sphere(const Patch& patch) {
    BoundingSphere widest;
    for (const int line : {0, 1, 2}) {
        const auto [low, high] = ends_along(patch, line);
        const Real radius = (high - low).norm() / 2;
        if (line == 0 || radius > widest.radius) widest = {(low + high) / 2, radius};
    }
    return sphere_grown_from(widest, patch);
}

/// In space, four points determine a sphere: a support never has more.
constexpr std::size_t largest_support = 4;

/// A few points, without the heap.
struct Points5 {
    std::array<Vec3, largest_support + 1> point;
    std::size_t count = 0;

    void add(const Vec3& p) { point[count++] = p; }

    [[nodiscard]] Real farthest_square(const Vec3& centre) const {
        Real square = 0;
        for (std::size_t k = 0; k < count; ++k) square = std::max(square, (point[k] - centre).squaredNorm());
        return square;
    }
};

/// The centre, in their line, plane or space, of the sphere through up to four points; none where one of them is in the
/// line or plane of the others. Point by point, the centre moves at right angles to all earlier points until the next
/// one is as far as they are. @cite gaertner1999
std::optional<Vec3> circumcentre(const Points5& points) {
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    const Vec3& origin = points.point[0];
    Vec3 centre = Vec3::Zero();   // from the origin
    Vec3 sides[largest_support];  // at right angles to one another
    for (std::size_t k = 1; k < points.count; ++k) {
        const Vec3 point = points.point[k] - origin;
        Vec3& side = sides[k];
        side = point;
        for (std::size_t j = 1; j < k; ++j) side -= side.dot(sides[j]) / sides[j].squaredNorm() * sides[j];
        const Real square = side.squaredNorm();
        if (!(square > epsilon * epsilon * point.squaredNorm())) return std::nullopt;
        centre += point.dot(point - 2 * centre) / (2 * square) * side;
    }
    return origin + centre;
}

struct SupportedSphere {
    Vec3 centre;
    Real square;  ///< of the radius, to the farthest of the points that it is about
    Points5 support;
};

/// The smallest sphere about a point and the support of another sphere, with the point on it: of all spheres through
/// the point and some of the support, the one that is smallest once it is grown to all of them.
/// Choosing by measure lets it pass over points that (nearly) coincide or are in one line, plane or circle.
SupportedSphere smallest_with(const Vec3& point, const Points5& others) {
    SupportedSphere best{point, others.farthest_square(point), {}};
    best.support.add(point);
    for (unsigned chosen = 1; chosen < 1u << others.count; ++chosen) {
        Points5 support;
        support.add(point);
        for (std::size_t k = 0; k < others.count; ++k) {
            if (chosen & 1u << k) support.add(others.point[k]);
        }
        if (support.count > largest_support) continue;
        const std::optional<Vec3> centre = circumcentre(support);
        if (!centre) continue;
        const Real square = std::max(others.farthest_square(*centre), (point - *centre).squaredNorm());
        if (square < best.square) best = {*centre, square, support};
    }
    return best;
}

/// The centre of the smallest sphere about the particles of a patch, to the rounding.
///
/// A sphere is held with its support, at most four particles on it that it is the smallest sphere about. The particle
/// that is farthest from its centre, if it stands out, is on the smallest sphere about itself and the support, which is
/// solved next; its radius can only grow, and ends when nothing stands out. @cite welzl1991 @cite gaertner1999
/// @par Cost O(particles) a pass; about ten passes; no heap
Vec3 smallest_sphere_centre(const Patch& patch) {
    constexpr Real rounding = 8 * std::numeric_limits<Real>::epsilon();
    constexpr int patience = 16;  // passes in which rounding may hide that the sphere gets better

    SupportedSphere sphere{patch.at(0, 0), 0, {}};
    Vec3 best = sphere.centre;
    Real least = std::numeric_limits<Real>::max(), largest = 0;  // the smallest sphere's radius is between, squared
    for (int waited = 0; waited < patience; ++waited) {
        const Vec3 farthest = farthest_particle(patch, sphere.centre);
        const Real square = (farthest - sphere.centre).squaredNorm();
        if (square < least) least = square, best = sphere.centre, waited = 0;
        if (square <= sphere.square * (1 + rounding)) break;
        sphere = smallest_with(farthest, sphere.support);
        if (sphere.square > largest) largest = sphere.square, waited = 0;
    }
    return best;
}

/// The smallest sphere about the ends of the lines, then grown. @cite larsson2008
template <int lines>
BoundingSphere fit_epos_sphere(const Patch& patch) {
    constexpr int count = 2 * lines;
    if (patch.particles() <= count) return fit_smallest_sphere(patch);
    Real x[count], y[count], z[count];
    for (int line = 0, k = 0; line < lines; ++line) {
        for (const Vec3& p : ends_along(patch, line)) x[k] = p[0], y[k] = p[1], z[k] = p[2], ++k;
    }
    return sphere_grown_from(fit_smallest_sphere({x, y, z, count, 1, count}), patch);
}

BoundingSphere sphere_about_by_kernels(const Patch& patch, const Vec3& centre) {
    Real square = 0;
    kernels::raise_to_farthest(patch, &centre, 1, &square);
    return {centre, BoundingSphere::radius_of(square)};
}

BoundingSphere fit_centroid_by_kernels(const Patch& patch) {
    if (patch.rows == 1) return BoundingSphere::fit(patch);
    return sphere_about_by_kernels(patch, kernels::mean(patch, kernels::sums(patch)));
}

BoundingSphere fit_box_by_kernels(const Patch& patch) {
    Vec3 low, high;
    kernels::dop_extents(patch, 3, low.data(), high.data());
    return sphere_about_by_kernels(patch, (low + high) / 2);
}

}  // namespace

BoundingSphere (*sphere_fit_of(SphereFit kind, Kernels kernels))(const Patch&) {
    // In the order of the kinds
    constexpr std::array by_kernels{fit_centroid_by_kernels, fit_box_by_kernels};
    constexpr std::array plain{BoundingSphere::fit, fit_box_sphere,      fit_ritter_sphere,  fit_epos_sphere<3>,
                               fit_epos_sphere<7>,  fit_epos_sphere<13>, fit_smallest_sphere};
    static_assert(plain.size() == enum_count<SphereFit>, "every kind has its fit");
    const auto k = static_cast<std::size_t>(kind);
    return kernels == Kernels::Vector && k < by_kernels.size() ? by_kernels[k] : plain[k];
}

BoundingSphere fit_smallest_sphere(const Patch& patch) { return sphere_about(patch, smallest_sphere_centre(patch)); }

}  // namespace drape
