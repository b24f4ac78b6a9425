#pragma once

#include <array>
#include <limits>
#include <optional>

#include "drape/contact/body.h"

namespace drape {

using Corners = std::array<Vec3, 3>;  ///< of a triangle [m]

/// The point of a triangle with the least signed distance from a solid.
struct DeepestPoint {
    std::array<Real, 3> barycentric{};
    Vec3 point = Vec3::Zero();  ///< [m]
    SurfaceDistance surface;
};

/// Finds it among the corners and the points that are nearest to the ridges of the shape; where that does not prove it,
/// by descent along the triangle from the lowest of these, the middles of edges and the centroid. @cite macklin2020
/// Outside a convex shape it is exact, to `deepest_tolerance`; else it may be a point that is lowest nearby.
/// @param corners of the triangle [m]
/// @param at_corners what the solid says of them
/// @param limit a point below this is found as without it, but on a mesh more may be missed; if there seems to be none,
///              any point may be returned that is not below it [m]
DeepestPoint find_deepest_point(const Solid& solid, const Corners& corners,
                                const std::array<SurfaceDistance, 3>& at_corners,
                                Real limit = std::numeric_limits<Real>::infinity());

/// What a search for the nearest point has found.
struct NearestPoint {
    std::optional<DeepestPoint> point;  ///< if it is below the limit
    Real bound;                         ///< no point is lower [m]
};

/// The same where something may be below a limit: a corner, unless another point is deeper than they are by more than
/// `deeper_than_corners`. Most triangles are decided by the distances of their corners.
NearestPoint find_nearest_point(const Solid& solid, const Corners& corners,
                                const std::array<SurfaceDistance, 3>& at_corners, Real limit);

}  // namespace drape
