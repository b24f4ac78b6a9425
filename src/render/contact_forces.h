#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "cloth_colours.h"
#include "drawn_nodes.h"

namespace drape {

/// Whether cloth sticks where it may touch.
enum class Hold : std::uint8_t {
    Sticks,
    Slides,  ///< friction is at the limit of its cone; without friction whatever touches slides
    Open     ///< nothing pushes
};

/// In the order of `Hold`, in sRGB. @cite okabe2008
inline constexpr std::array<LineLook, 3> hold_looks{{{"sticks", {0.337f, 0.706f, 0.914f, 1}},
                                                     {"slides", {0.941f, 0.894f, 0.259f, 1}},
                                                     {"no force", {0.75f, 0.75f, 0.78f, 1}}}};

/// What a body does to cloth in a contact, as it is drawn.
struct ContactForce {
    Vec3 force = Vec3::Zero();  ///< on the cloth, the mean of the last substep [N]
    Hold hold = Hold::Open;
};

/// @param row of `ClothView::contacts`, whose impulse a response has found
inline ContactForce force_of(const FrameView& view, const ContactRow& row) {
    constexpr Real at_the_limit = Real(0.999);
    const Settings& settings = *view.settings;
    const Real h = static_cast<Real>(settings.solver.dt / std::max(view.report->substeps, 1));
    const bool is_ground = row.body == static_cast<int>(view.balls.size() + view.solids.size());
    const Real most = (is_ground ? settings.ground.friction : settings.contact.friction) * row.impulse.normal;
    if (row.impulse.normal == 0) return {};
    const bool slides = row.impulse.friction.norm() >= at_the_limit * most;
    return {row.impulse.about(row.normal) / h, slides ? Hold::Slides : Hold::Sticks};
}

/// What an arrow of full length stands for [N]: 1, 2 or 5 times a power of ten, no less than the largest force that is
/// on show; 0 if there is none. @par Cost one look at each contact
inline double full_force(const FrameView& view) {
    Real largest = 0;
    for (const ClothView& cloth : view.cloths) {
        for (const ContactRow& row : cloth.contacts) largest = std::max(largest, force_of(view, row).force.norm());
    }
    return largest > 0 ? round_number_above(static_cast<double>(largest)) : 0;
}

}  // namespace drape
