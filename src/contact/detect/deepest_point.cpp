#include "deepest_point.h"

#include <algorithm>
#include <cmath>

#include "contact/tuning.h"
#include "drape/contact/closest_point.h"

// Of a convex shape, a triangle that does not cross it is nearest to it with a corner, or to one of its ridges. What is
// left, a mesh and what is inside, is found by descent with projection: p' = the point of the triangle nearest to p - s
// n, with the step s halved where that leads up, and doubled where it leads down. It ends where no corner is lower by
// the slope at p, which no point of a convex function then is either (the gap of Frank and Wolfe); and where a step
// down gains next to nothing, as across a ridge, where the slope never says so.

namespace drape {
namespace {

/// By how much the slope at a point lets some point of the triangle be lower [m].
Real slope_gap(const DeepestPoint& at, const Corners& corners) {
    Real gap = 0;
    for (const Vec3& corner : corners) gap = std::max(gap, at.surface.normal.dot(at.point - corner));
    return gap;
}

DeepestPoint lowest_corner(const Corners& corners, const std::array<SurfaceDistance, 3>& at_corners) {
    const auto lowest = std::ranges::min_element(at_corners, {}, &SurfaceDistance::distance);
    const auto k = static_cast<std::size_t>(lowest - at_corners.begin());
    DeepestPoint found{.barycentric = {}, .point = corners[k], .surface = *lowest};
    found.barycentric[k] = 1;
    return found;
}

/// No point of a triangle is farther than this from the nearest corner: in one without an obtuse angle the radius of
/// the circle through all three, else no more than half of the longest side [m].
Real covering_radius(const Corners& corners) {
    std::array<Real, 3> squares;
    for (std::size_t k = 0; k < 3; ++k) squares[k] = (corners[k] - corners[(k + 1) % 3]).squaredNorm();
    std::ranges::sort(squares);
    const auto [a, b, c] = squares;
    // Twice the product of the two shorter sides and the cosine between them; 16 area^2 = 4 a b - acute^2
    const Real acute = a - (c - b);
    if (!(acute > 0)) return std::sqrt(c) / 2;
    return std::sqrt(c / (4 - (acute / a) * (acute / b)));
}

/// No point of a triangle is nearer than this [m]: by its size and, where the distance is convex, by its gradients at
/// the corners.
Real bound_of(const Solid& solid, const Corners& corners, const std::array<SurfaceDistance, 3>& at_corners) {
    Real bound = std::ranges::min(at_corners, {}, &SurfaceDistance::distance).distance - covering_radius(corners);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 first = corners[k] - corners[(k + 1) % 3], second = corners[k] - corners[(k + 2) % 3];
        const Vec3& normal = at_corners[k].normal;
        const Real fall = solid.shape->is_convex() ? std::max({normal.dot(first), normal.dot(second), Real(0)})
                                                   : std::max(first.norm(), second.norm());
        bound = std::max(bound, at_corners[k].distance - fall);
    }
    return bound;
}

/// A triangle and the lowest of its points so far.
struct Descent {
    const Solid& solid;
    const Corners& corners;
    DeepestPoint best;

    void take(const std::array<Real, 3>& weights) {
        const Vec3 point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
        const SurfaceDistance surface = solid.measure(point);
        if (surface.distance < best.surface.distance) best = {weights, point, surface};
    }

    /// What of the triangle is closest to a segment: a point of a side, or one that an end of the segment is nearest
    /// to.
    void take_nearest(const Segment& segment) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            std::array<Real, 3> weights{};
            weights[next] = closest_of_segments(corners[k], corners[next], segment[0], segment[1]).first;
            weights[k] = 1 - weights[next];
            take(weights);
        }
        for (const Vec3& end : segment)
            take(closest_point_on_triangle(end, corners[0], corners[1], corners[2]).barycentric);
    }
};

/// Of the ridges, only those that may be the nearest part of the solid: no farther from a corner than the solid and the
/// triangle's size.
void try_ridges(Descent& descent, Real size) {
    const Solid& solid = descent.solid;
    const Vec3& corner = descent.corners[0];
    const std::span<const Segment> ridges = solid.shape->ridges();
    const Real farthest = std::abs(descent.best.surface.distance) + 2 * size;
    for (const Segment& own : ridges) {
        const Segment ridge{solid.position + solid.orientation * own[0], solid.position + solid.orientation * own[1]};
        const Real distance = closest_of_segments(corner, corner, ridge[0], ridge[1]).offset.norm();
        if (ridges.size() == 1 || distance <= farthest) descent.take_nearest(ridge);
    }
}

void try_middles(Descent& descent) {
    constexpr Real third = Real(1) / 3, half = Real(0.5);
    descent.take({third, third, third});
    for (const auto& middle : {std::array<Real, 3>{0, half, half}, {half, 0, half}, {half, half, 0}}) {
        descent.take(middle);
    }
}

}  // namespace

DeepestPoint find_deepest_point(const Solid& solid, const Corners& corners,
                                const std::array<SurfaceDistance, 3>& at_corners, Real limit) {
    Descent descent{solid, corners, lowest_corner(corners, at_corners)};
    DeepestPoint& best = descent.best;
    const bool is_convex = solid.shape->is_convex();
    if (is_convex && slope_gap(best, corners) <= deepest_tolerance) return best;
    const Real size = std::max((corners[1] - corners[0]).norm(), (corners[2] - corners[0]).norm());
    try_ridges(descent, size);
    if (is_convex && slope_gap(best, corners) <= deepest_tolerance) return best;
    try_middles(descent);
    Real step = std::max(size, deepest_tolerance);
    const auto is_done = [&] {
        const Real gap = slope_gap(best, corners);
        return gap <= deepest_tolerance || best.surface.distance - gap_margin * gap > limit;
    };
    for (int k = 0; k < max_descents && !is_done(); ++k) {
        const Vec3 down = best.point - step * best.surface.normal;
        const Real before = best.surface.distance;
        descent.take(closest_point_on_triangle(down, corners[0], corners[1], corners[2]).barycentric);
        const Real gain = before - best.surface.distance;
        if (gain > 0 && gain < deepest_tolerance) break;
        step *= gain > 0 ? Real(2) : Real(0.5);
    }
    return best;
}

NearestPoint find_nearest_point(const Solid& solid, const Corners& corners,
                                const std::array<SurfaceDistance, 3>& at_corners, Real limit) {
    const DeepestPoint corner = lowest_corner(corners, at_corners);
    const Real least = std::min(limit, corner.surface.distance - deeper_than_corners);
    Real bound = bound_of(solid, corners, at_corners);
    if (bound < least && least > 0) {
        const Real asked = least + clearance_asked * (corner.surface.distance - least);
        bound = std::max(bound, solid.clearance(corners, asked));
    }
    if (bound < least) {
        const DeepestPoint deepest = find_deepest_point(solid, corners, at_corners, least);
        // On a mesh the slope proves nothing
        if (solid.shape->is_convex()) {
            bound = std::max(bound, deepest.surface.distance - slope_gap(deepest, corners));
        }
        if (deepest.surface.distance < least) return {deepest, bound};
    }
    return {corner.surface.distance < limit ? std::optional(corner) : std::nullopt, bound};
}

}  // namespace drape
