#pragma once

#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// Steps that the fits of spheres have in common, whichever way their passes over the particles run.

/// A few points, as a patch of one row.
template <int count>
struct FewPoints {
    Real x[count], y[count], z[count];

    void set(int k, const Vec3& p) { x[k] = p[0], y[k] = p[1], z[k] = p[2]; }
    [[nodiscard]] Patch patch() const { return {x, y, z, count, 1, count}; }
};

/// The particles at both ends of each of a few lines: one after the other, those of the first line first. Of several
/// equally far out it is the first.
template <int lines>
using LineEnds = FewPoints<2 * lines>;

/// The sphere about the two ends of the line whose ends are farthest apart. @cite ritter1990
BoundingSphere sphere_about_widest(const LineEnds<3>& ends);

/// One pass in which a sphere takes in, one after the other, the particles that stand out of it, each by as little as
/// possible: with d = |p - c| > r, c += (d - r)/2 (p - c)/d and r += (d - r)/2. @cite ritter1990
/// @return the centre of the grown sphere
Vec3 grown_centre(const Patch& patch, BoundingSphere sphere);

/// A pass that finds the particle farthest from a point.
using FindFarthest = Vec3 (*)(const Patch&, const Vec3& from);

/// The centre of the smallest sphere about the particles of a patch, to the rounding.
///
/// A sphere is held with its support, at most four particles on it that it is the smallest sphere about. The particle
/// that is farthest from its centre, if it stands out, is on the smallest sphere about itself and the support, which is
/// solved next; its radius can only grow, and ends when nothing stands out. @cite welzl1991 @cite gaertner1999
/// @par Cost O(particles) a pass; about ten passes; no heap
Vec3 smallest_sphere_centre(const Patch& patch, FindFarthest find_farthest);

}  // namespace drape
