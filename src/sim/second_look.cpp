#include <algorithm>

#include "drape/sim/simulation.h"

namespace drape {

/// Where something has come past the middle of a ball, the response moves cloth so far that it may meet the ball
/// elsewhere: the substep's way, as it is now, is tested and answered once more, by projection, which puts positions
/// back at once.
void Simulation::look_again(const Substep& now) {
    const auto has_passing = [](const Cloth& cloth) { return cloth.search.found_passing(); };
    if (settings_.contact.response == ResponseKind::Penalty || std::ranges::none_of(cloths_, has_passing)) return;
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
    answer(response, now, {}, {});
    for (Cloth& cloth : cloths_) cloth.contacts.swap(cloth.first_contacts);
}

}  // namespace drape
