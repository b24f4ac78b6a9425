#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/advance.h"
#include "contact/tuning.h"
#include "drape/contact/detection.h"

namespace drape {
namespace {

/// Of a height that was computed.
constexpr Real height_rounding = 16 * std::numeric_limits<Real>::epsilon();

/// The surface of a body next to a ball's centre.
struct NextTo {
    Vec3 normal;
    Real height;  ///< along the normal [m]
};

NextTo next_to(const SurfaceDistance& surface, const Vec3& centre) {
    return {surface.normal, surface.normal.dot(centre) - surface.distance};
}

/// Where a ball first comes as near as its radius, on a path that is seen from the body, by conservative advancement.
std::optional<NextTo> first_plane(const Body& body, const Vec3& from, const Vec3& to, Real radius) {
    const Real length = (to - from).norm();
    if (length == 0) return std::nullopt;
    Vec3 centre;
    SurfaceDistance surface;
    const auto measure = [&](Real t) -> Advance {
        centre = from + t * (to - from);
        surface = body.measure(centre);
        return {surface.distance, t + (surface.distance - radius - touch_distance / 2) / length};
    };
    if (!first_time(measure, radius + touch_distance)) return std::nullopt;
    return next_to(surface, centre);
}

/// The plane that holds a ball within the substep: that at its end, or where it has met the body.
std::optional<NextTo> plane_for(const Body& body, const Vec3& from, const Vec3& to, Real radius) {
    const NextTo at_end = next_to(body.measure(to), to);
    const bool touches = at_end.normal.dot(to) - at_end.height < radius;
    const auto met = first_plane(body, from, to, radius);
    const bool has_passed = met && met->normal.dot(to) - met->height < radius;
    // Balls throw each other in the direction in which they met; on all else a ball lies more calmly as it is at the
    // end
    const bool has_turned = body.is_ball() || (met && met->normal.dot(at_end.normal) < same_side);
    if (has_passed && (!touches || has_turned)) return met;
    return touches ? std::optional(at_end) : std::nullopt;
}

}  // namespace

void find_body_contacts(std::span<const Body> bodies, std::vector<ContactRow>& rows) {
    for (std::size_t first = 0; first < bodies.size() && bodies[first].is_ball(); ++first) {
        for (std::size_t second = first + 1; second < bodies.size(); ++second) {
            const Body &ball = bodies[first], &body = bodies[second];
            if (ball.inverse_mass == 0 && body.inverse_mass == 0) continue;
            const auto plane = plane_for(body, ball.centre - ball.moved + body.moved, ball.centre, ball.radius);
            if (!plane) continue;
            ContactRow& row = rows.emplace_back();
            row.kind = RowKind::Bodies;
            row.first_body = static_cast<int>(first);
            row.body = static_cast<int>(second);
            row.normal = plane->normal;
            row.depth = plane->height + ball.radius - plane->normal.dot(ball.centre);
            row.distance = row.depth + row.normal.dot(ball.centre - body.centre);
        }
    }
}

bool stay_outside(std::span<const Body> bodies, const Vec3& start, Real gap, Ball& ball) {
    if (bodies.empty()) return false;
    const Real radius = ball.radius + gap;
    bool is_out = false, was_out = true;
    for (int k = 0; k < max_passes && !is_out; ++k) {
        is_out = true;
        for (const Body& body : bodies) {
            const auto plane = plane_for(body, start + body.moved, ball.centre, radius);
            if (!plane) continue;
            const Real depth = plane->height + radius - plane->normal.dot(ball.centre);
            if (depth <= height_rounding * (std::abs(plane->height) + radius)) continue;  // as near as numbers come
            is_out = was_out = false;
            ball.centre += depth * plane->normal;
            const Real towards = plane->normal.dot(ball.velocity - body.velocity);
            ball.velocity -= std::min(towards, Real(0)) * plane->normal;
            ball.moved = ball.centre - start;
        }
    }
    if (is_out) return !was_out;
    ball.centre = start;  // wedged
    ball.velocity.setZero();
    ball.moved.setZero();
    return true;
}

bool penetrates_no_deeper(std::span<const Body> bodies, Real gap, const Ball& ball) {
    const Vec3 start = ball.centre - ball.moved;
    const Real radius = ball.radius + gap;
    return std::ranges::all_of(bodies, [&](const Body& body) {
        const Real size = ball.centre.cwiseAbs().sum() + body.centre.cwiseAbs().sum() + radius;
        // Less than the path, or a slow ball would creep in
        const Real rounding = std::min(height_rounding * size, ball.moved.norm() / 2);
        const Vec3 from = start + body.moved;
        const Real allowed = std::min({radius, body.measure(from).distance, body.measure(start).distance});
        return !plane_for(body, from, ball.centre, allowed - rounding);
    });
}

}  // namespace drape
