#include <algorithm>

#include "drape/contact/ball_solids.h"
#include "drape/sim/simulation.h"

namespace drape {

/// Where something has come past the middle of a ball, the response moves cloth, and a free ball, so far that they may
/// meet elsewhere: the substep's way, as it is now, is tested and answered again, by projection, which puts positions
/// back at once; until nothing passes any more. A light ball that draws a few triangles out far may need more
/// than eight.
void Simulation::look_again(const Substep& now) {
    if (settings_.contact.response == ResponseKind::Penalty) return;
    bool passing = has_passing(ball_contacts_);
    for (int look = 0; look < most_looks && passing; ++look) {
        answer_way(now);
        passing = has_passing(found_again_);
    }
}

/// Whether anything has passed a ball.
bool Simulation::has_passing(std::span<const BallContact> ball_contacts) const {
    return std::ranges::any_of(cloths_, [](const Cloth& cloth) { return cloth.search.found_passing(); }) ||
           std::ranges::any_of(ball_contacts, &BallContact::of_impact);
}

/// Tests the substep's way as it is now, and answers what it finds.
void Simulation::answer_way(const Substep& now) {
    for (Cloth& cloth : cloths_) {
        cloth.contacts.swap(cloth.first_contacts);
        cloth.search.look_again(start_of_substep(cloth), cloth.state.x, balls_, settings_.contact.thickness,
                                cloth.contacts);
        meet_solids(cloth);
        if (!settings_.ground.solid) continue;
        cloth.search.meet_ground(cloth.state.x, settings_.ground.height, settings_.contact.thickness, cloth.contacts);
    }
    ResponseParameters response = response_of(settings_);
    response.kind = ResponseKind::Projection;
    find_ball_contacts(balls_, settings_.ground, found_again_);
    find_ball_contacts(balls_, solids_, found_again_);
    answer(response, now, {}, found_again_);
    for (Cloth& cloth : cloths_) cloth.contacts.swap(cloth.first_contacts);
}

}  // namespace drape
