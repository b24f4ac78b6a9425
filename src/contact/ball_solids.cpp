#include "drape/contact/ball_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace drape {
namespace {

/// What advances on its way goes on until it is as near as this [m].
constexpr Real nearest_way = Real(1e-6);

constexpr int most_ways = 256;

/// The least cosine between the normal at the end and that at which they met, for both to be of one side.
constexpr Real same_side_of_ball = Real(0.5);

/// Passes over all solids, each of which may put a ball out of what it was not in before: a corner takes three.
constexpr int most_passes = 4;

/// Of a height that was computed.
constexpr Real height_rounding = 16 * std::numeric_limits<Real>::epsilon();

/// The surface of a solid next to a ball's centre.
struct NextTo {
    Vec3 normal;
    Real height;  ///< along the normal [m]
};

NextTo surface_next_to(const Solid& solid, const Vec3& centre) {
    const SurfaceDistance surface = solid.measure(centre);
    return {surface.normal, surface.normal.dot(centre) - surface.distance};
}

/// Where a ball first comes as near as its radius, on a way that is seen from the solid.
std::optional<NextTo> first_meeting(const Solid& solid, const Vec3& from, const Vec3& to, Real radius) {
    const Real length = (to - from).norm();
    if (length == 0) return std::nullopt;
    Real gone = 0;
    for (int k = 0; k < most_ways; ++k) {
        const Vec3 centre = from + gone / length * (to - from);
        const SurfaceDistance surface = solid.measure(centre);
        const Real left = surface.distance - radius;
        if (left <= nearest_way || k + 1 == most_ways) {
            return NextTo{surface.normal, surface.normal.dot(centre) - surface.distance};
        }
        gone += left - nearest_way / 2;
        if (!(gone < length)) return std::nullopt;
    }
    return std::nullopt;
}

/// The plane that holds a ball within the substep: that at its end, or where it has met the solid.
std::optional<NextTo> plane_for(const Solid& solid, const Vec3& from, const Vec3& to, Real radius) {
    const NextTo at_end = surface_next_to(solid, to);
    const bool touches = at_end.normal.dot(to) - at_end.height < radius;
    const auto met = first_meeting(solid, from, to, radius);
    const bool has_passed = met && met->normal.dot(to) - met->height < radius;
    if (has_passed && (!touches || met->normal.dot(at_end.normal) < same_side_of_ball)) return met;
    return touches ? std::optional(at_end) : std::nullopt;
}

}  // namespace

void find_ball_contacts(std::span<const Ball> balls, std::span<const Solid> solids,
                        std::vector<BallContact>& contacts) {
    for (std::size_t b = 0; b < balls.size(); ++b) {
        const Ball& ball = balls[b];
        if (ball.inverse_mass == 0) continue;
        for (std::size_t s = 0; s < solids.size(); ++s) {
            const Solid& solid = solids[s];
            const auto plane = plane_for(solid, ball.centre - ball.moved + solid.moved, ball.centre, ball.radius);
            if (!plane) continue;
            BallContact contact;
            contact.first = static_cast<int>(b);
            contact.ball = first_solid + static_cast<int>(s);
            contact.normal = plane->normal;
            contact.plane = {plane->height, solid.moved, solid.velocity};
            contact.depth = plane->height + ball.radius - plane->normal.dot(ball.centre);
            contacts.push_back(contact);
        }
    }
}

bool stay_outside(std::span<const Solid> solids, const Vec3& start, Real gap, Real h, Ball& ball) {
    if (solids.empty()) return false;
    const Real radius = ball.radius + gap;
    bool is_out = false, was_out = true;
    for (int k = 0; k < most_passes && !is_out; ++k) {
        is_out = true;
        for (const Solid& solid : solids) {
            const auto plane = plane_for(solid, start + solid.moved, ball.centre, radius);
            if (!plane) continue;
            const Real depth = plane->height + radius - plane->normal.dot(ball.centre);
            if (depth <= height_rounding * (std::abs(plane->height) + radius)) continue;  // as near as numbers come
            is_out = was_out = false;
            ball.centre += depth * plane->normal;
            const Real towards = plane->normal.dot(ball.velocity - solid.velocity);
            ball.velocity -= std::min(towards, Real(0)) * plane->normal;
            ball.moved = h * ball.velocity;
        }
    }
    if (is_out) return !was_out;
    ball.centre = start;  // wedged
    ball.velocity.setZero();
    ball.moved.setZero();
    return true;
}

bool penetrates_no_deeper(std::span<const Solid> solids, Real gap, const Ball& ball) {
    const Vec3 start = ball.centre - ball.moved;
    const Real radius = ball.radius + gap;
    return std::ranges::all_of(solids, [&](const Solid& solid) {
        const Real size = ball.centre.cwiseAbs().sum() + solid.position.cwiseAbs().sum() + radius;
        // Less than the path, or a slow ball would creep in
        const Real rounding = std::min(height_rounding * size, ball.moved.norm() / 2);
        const Vec3 from = start + solid.moved;
        const Real allowed = std::min({radius, solid.distance(from), solid.distance(start)});
        return !plane_for(solid, from, ball.centre, allowed - rounding);
    });
}

}  // namespace drape
