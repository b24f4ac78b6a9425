#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "drape/model/ball.h"
#include "drape/model/grid.h"

namespace drape {

/// The distance of p from the segment from a to b.
inline Real distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const Real square = ab.squaredNorm();
    const Real t = square > 0 ? std::clamp((p - a).dot(ab) / square, Real(0), Real(1)) : Real(0);
    return (a + t * ab - p).norm();
}

/// The distance of p from triangle a, b, c: from its plane if p stands over it, else from its nearest side. Written to
/// be plainly right and unlike the code under test, not to be fast.
inline Real distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const bool over =
        n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 && n.dot((a - c).cross(p - c)) >= 0;
    const Real sides =
        std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
    if (!over || n.squaredNorm() == 0) return sides;
    return std::min(sides, std::abs((p - a).dot(n.normalized())));
}

/// The distance of p from a triangle of a cloth at x.
inline Real distance_to_triangle(const Vec3& p, const Grid& grid, const Points& x, int triangle) {
    const auto corners = grid.triangle_corners(triangle);
    return distance_to_triangle(p, x.row(corners[0]).transpose(), x.row(corners[1]).transpose(),
                                x.row(corners[2]).transpose());
}

/// How deep the deepest triangle is in the ball, the cloth's thickness not counted; negative if none touches it.
inline Real deepest_triangle(const Grid& grid, const Points& x, const Ball& ball) {
    Real nearest = (x.row(0).transpose() - ball.centre).norm();
    for (int t = 0; t < grid.triangles(); ++t) {
        nearest = std::min(nearest, distance_to_triangle(ball.centre, grid, x, t));
    }
    return ball.radius - nearest;
}

}  // namespace drape
