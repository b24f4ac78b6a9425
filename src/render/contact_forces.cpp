#include "contact_forces.h"

#include <algorithm>

#include "cloth_colours.h"

namespace drape {

ContactForce force_of(const FrameView& view, const ContactRow& row) {
    constexpr Real at_the_limit = Real(0.999);
    const Settings& settings = *view.settings;
    const Real h = static_cast<Real>(settings.solver.dt / std::max(view.report->substeps, 1));
    const bool is_ground = row.body == static_cast<int>(view.balls.size() + view.solids.size());
    const Real most = (is_ground ? settings.ground.friction : settings.contact.friction) * row.impulse.normal;
    if (row.impulse.normal == 0) return {};
    const bool slides = row.impulse.friction.norm() >= at_the_limit * most;
    return {row.impulse.about(row.normal) / h, slides ? Hold::Slides : Hold::Sticks};
}

double full_force(const FrameView& view) {
    Real largest = 0;
    for (const ClothView& cloth : view.cloths) {
        for (const ContactRow& row : cloth.contacts) largest = std::max(largest, force_of(view, row).force.norm());
    }
    return largest > 0 ? round_number_above(static_cast<double>(largest)) : 0;
}

}  // namespace drape
