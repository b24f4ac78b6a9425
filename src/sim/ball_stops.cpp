#include "ball_stops.h"

#include <algorithm>

#include "drape/model/stretch_limit.h"

namespace drape {
namespace {

/// By how much of its rest length a spring is beyond the limit where cloth counts as taut: contact, which comes after
/// the limit, has drawn it out by as much.
constexpr Real taut = Real(0.02);

/// Contacts are gone through so many times; where the ball still moves into one, it is wedged.
constexpr int most_rounds = 8;

/// Takes from the way of a ball within the substep some of what goes along a normal, and its velocity along it.
void take_back(const Vec3& normal, Real length, Real h, Ball& ball) {
    ball.centre -= length * normal;
    ball.velocity -= std::max(normal.dot(ball.velocity), Real(0)) * normal;
    ball.moved = h * ball.velocity;
}

/// @return whether the ball goes into no contact
bool stop_at_contacts(const Cloth& cloth, int number, Real h, Ball& ball) {
    bool is_free = true;
    for (const Contact& contact : cloth.contacts) {
        const Real towards = contact.normal.dot(ball.moved);
        if (contact.ball != number || !(towards > 0)) continue;
        is_free = false;
        take_back(contact.normal, towards, h, ball);
    }
    return is_free;
}

}  // namespace

void stop_at_taut_cloth(std::span<const Cloth> cloths, int number, Real h, Ball& ball) {
    for (const Cloth& cloth : cloths) {
        if (std::ranges::find(cloth.contacts, number, &Contact::ball) == cloth.contacts.end()) continue;
        if (!(stretch_excess(cloth.model, cloth.state.x) > taut)) continue;
        const Vec3 start = ball.centre - ball.moved;
        int round = 0;
        while (!stop_at_contacts(cloth, number, h, ball) && round < most_rounds) ++round;
        if (round < most_rounds) continue;
        ball.centre = start;
        ball.velocity.setZero();
        ball.moved.setZero();
    }
}

void stop_at_pins(std::span<const Cloth> cloths, Real gap, Real h, Ball& ball) {
    const Vec3 start = ball.centre - ball.moved;
    for (const Cloth& cloth : cloths) {
        for (int p = 0; p < cloth.model.grid.particles(); ++p) {
            if (!cloth.model.pinned(p) || p == cloth.held) continue;  // the hand gives way
            const Vec3 pin = cloth.state.x.row(p).transpose(), offset = pin - ball.centre;
            const Real distance = offset.norm(), least = std::min(ball.radius + gap, (pin - start).norm());
            if (distance < least && distance > 0) take_back(offset / distance, least - distance, h, ball);
        }
    }
}

}  // namespace drape
