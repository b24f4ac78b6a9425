#pragma once

#include "drape/base/enum_names.h"
#include "drape/base/kernels.h"
#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// How a sphere is put about the particles of a node, from the dissertation's way to the smallest sphere there is.
/// Costs are in passes over the particles.
enum class SphereFit {
    /// About the mean, `BoundingSphere::fit`: two passes. @cite dissertation
    Centroid,
    /// About the centre of the box along the axes, c = (min x_p + max x_p) / 2, through the farthest particle: two.
    BoxCentre,
    /// Of the pairs of particles at the ends of the three axes, the sphere about the two that are farthest apart, grown
    /// by every particle that stands out of it: five. @cite ritter1990
    Ritter,
    /// The smallest sphere about the particles that are farthest out along 3, 7 or 13 lines (`dop_axes`), grown by
    /// every particle that stands out of it; the smallest sphere itself where there are no more particles than ends of
    /// lines: one for each line, and two. @cite larsson2008
    Epos6,
    Epos14,
    Epos26,
    /// The smallest, to the rounding: about ten. @cite welzl1991 @cite gaertner1999
    Welzl
};

template <>
inline constexpr std::string_view other_name<SphereFit::BoxCentre> = "box";

/// The fit of a kind: plain or, of the first two kinds, by vector kernels if they are asked for.
[[nodiscard]] BoundingSphere (*sphere_fit_of(SphereFit kind, Kernels kernels))(const Patch&);

/// The smallest sphere, to the rounding: the plain `SphereFit::Welzl`.
BoundingSphere fit_smallest_sphere(const Patch& patch);

}  // namespace drape
