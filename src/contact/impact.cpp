#include "drape/contact/impact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "advance.h"
#include "drape/bounds/aabb.h"
#include "drape/contact/closest_point.h"

namespace drape {
namespace {

using Corners3 = std::array<Vec3, 3>;

/// Of the ball's radius, that a touch is looked for inside it: a shallower one may be missed. And of the largest
/// coordinate, for rounding.
constexpr Real depth_of_touch = Real(1e-5), rounding = 16 * std::numeric_limits<Real>::epsilon();

/// A triangle as the ball's centre sees it, over the whole step.
struct SeenTriangle {
    Corners3 start, end;

    SeenTriangle(const SweptBall& ball, const Corners3& from, const Corners3& to) {
        for (std::size_t k = 0; k < 3; ++k) start[k] = from[k] - ball.start, end[k] = to[k] - ball.end;
    }

    [[nodiscard]] Corners3 at(Real t) const {
        Corners3 corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = (1 - t) * start[k] + t * end[k];
        return corners;
    }

    [[nodiscard]] ClosestPoint nearest_at(Real t) const {
        const auto [a, b, c] = at(t);
        return closest_point_on_triangle(Vec3::Zero(), a, b, c);
    }

    /// Until when all corners stay beyond a plane at this distance from the centre; infinity: throughout.
    [[nodiscard]] Real beyond_until(const Vec3& normal, Real distance) const {
        Real until = std::numeric_limits<Real>::infinity();
        for (std::size_t k = 0; k < 3; ++k) {
            const Real first = normal.dot(start[k]) - distance, last = normal.dot(end[k]) - distance;
            if (last < 0) until = std::min(until, first / (first - last));
        }
        return until;
    }

    [[nodiscard]] Aabb box() const {
        Aabb all{start[0], start[0]};
        for (std::size_t k = 0; k < 3; ++k) all.include(start[k]), all.include(end[k]);
        return all;
    }
};

/// A triangle through the very centre is met along its own normal.
Vec3 normal_through_centre(const SeenTriangle& seen, Real t) {
    const auto [a, b, c] = seen.at(t);
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();
    if (normal.isZero(0)) return {0, 1, 0};
    return normal.dot(seen.end[0] - seen.start[0]) > 0 ? Vec3(-normal) : normal;
}

}  // namespace

std::optional<Impact> first_impact(const SweptBall& ball, const Corners3& from, const Corners3& to) {
    const SeenTriangle seen(ball, from, to);
    const Aabb box = seen.box();
    if (!box.overlaps(Ball{.centre = Vec3::Zero(), .radius = ball.radius})) return std::nullopt;
    const Real size = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
    const Real aim = ball.radius - std::max(depth_of_touch * ball.radius, rounding * size);
    ClosestPoint nearest;
    Real distance = 0;
    const auto measure = [&](Real t) -> Advance {
        nearest = seen.nearest_at(t);
        distance = nearest.point.norm();
        if (distance <= ball.radius) return {distance, t};
        // All of the triangle is beyond the plane through its closest point
        return {distance, seen.beyond_until(nearest.point / distance, aim)};
    };
    const std::optional<Real> time = first_time(measure, ball.radius);
    if (!time) return std::nullopt;
    const Vec3 normal = distance > 0 ? Vec3(nearest.point / distance) : normal_through_centre(seen, *time);
    return Impact{*time, nearest.barycentric, normal};
}

}  // namespace drape
