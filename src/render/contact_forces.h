#pragma once

#include <array>
#include <cstdint>

#include "node_states.h"

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
ContactForce force_of(const FrameView& view, const ContactRow& row);

/// What an arrow of full length stands for [N]: 1, 2 or 5 times a power of ten, no less than the largest force that is
/// on show; 0 if there is none. @par Cost one look at each contact
double full_force(const FrameView& view);

}  // namespace drape
