#pragma once

#include <string>

#include "drape/base/enum_names.h"
#include "drape/base/kernels.h"
#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// How a sphere is put about the particles of a node: from the dissertation's way to the smallest sphere there is.
enum class SphereFit {
    Centroid,   ///< about the mean: `BoundingSphere::fit`
    BoxCentre,  ///< about the centre of the box along the axes
    Ritter,     ///< about two particles far apart, then grown
    Epos6,      ///< about 6 extremal particles, then grown
    Epos14,     ///< about 14
    Epos26,     ///< about 26
    Welzl       ///< the smallest
};

template <>
inline constexpr auto enum_names<SphereFit> = all_names<SphereFit>("centroid", "box", "ritter", "epos6", "epos14",
                                                                   "epos26", "welzl");

/// About the centre of the box along the axes, c = (min x_p + max x_p) / 2, through the farthest particle.
/// @par Cost O(particles), two passes
BoundingSphere fit_box_sphere(const Patch& patch);

/// Of the pairs of particles at the ends of the three axes, the sphere about the two that are farthest apart, grown by
/// every particle that stands out of it. @cite ritter1990
/// @par Cost O(particles), five passes
BoundingSphere fit_ritter_sphere(const Patch& patch);

/// The smallest sphere about the particles that are farthest out along 3, 7 or 13 lines (`dop_axes`), grown by every
/// particle that stands out of it; the smallest sphere itself where there are no more particles than ends of lines.
/// @cite larsson2008
/// @par Cost O(particles), a pass for each line and two
BoundingSphere fit_epos6_sphere(const Patch& patch);
BoundingSphere fit_epos14_sphere(const Patch& patch);
BoundingSphere fit_epos26_sphere(const Patch& patch);

/// The smallest sphere, to the rounding. @cite welzl1991 @cite gaertner1999
/// @par Cost O(particles) a pass; about ten passes
BoundingSphere fit_smallest_sphere(const Patch& patch);

/// The fit of a kind: one of the above, or its vector kernel.
[[nodiscard]] BoundingSphere (*sphere_fit_of(SphereFit kind, Kernels kernels = Kernels::Vector))(const Patch&);

}  // namespace drape
