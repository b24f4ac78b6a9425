#include <optional>

#include "contact/advance.h"
#include "contact/tuning.h"
#include "drape/contact/detection.h"

namespace drape {
namespace {

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

void find_body_contacts(std::span<const Body> bodies, Real thickness, std::vector<ContactRow>& rows) {
    for (std::size_t first = 0; first < bodies.size() && bodies[first].is_ball(); ++first) {
        for (std::size_t second = first + 1; second < bodies.size(); ++second) {
            const Body &ball = bodies[first], &body = bodies[second];
            const bool stops = stops_motor(ball, body);
            if (!stops && ball.inverse_mass + body.inverse_mass == 0) continue;
            const Real radius = ball.radius + (stops ? 2 * thickness : Real(0));
            const auto plane = plane_for(body, ball.centre - ball.moved + body.moved, ball.centre, radius);
            if (!plane) continue;
            ContactRow& row = rows.emplace_back();
            row.kind = RowKind::Bodies;
            row.first_body = static_cast<int>(first);
            row.body = static_cast<int>(second);
            row.normal = plane->normal;
            row.depth = plane->height + radius - plane->normal.dot(ball.centre);
            row.distance = row.depth + row.normal.dot(ball.centre - body.centre);
        }
    }
}

}  // namespace drape
