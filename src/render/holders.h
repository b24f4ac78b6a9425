#pragma once

#include <Eigen/Core>
#include <vector>

#include "drape/sim/frame_view.h"

namespace drape {

/// A piece of what pins hang from: a rod with round ends, a ball if it has no length; or a ring about an axis.
struct Holder {
    Eigen::Vector3f from;  ///< one end, or the centre of a ring
    float radius;          ///< of the rod, or of the ring's wire [m]
    Eigen::Vector3f to;    ///< the other end; or the axis of a ring, of length 1
    float ring;            ///< radius of a ring; 0: a rod [m]
};

/// Thinner ones cast no shadow; as in `shaders/holder_depth.vert` [m].
constexpr float thinnest_caster = 0.0075f;

/// What the pins of all cloths hang from. Of a cloth that starts upright, a rod with rings for the upper row and a pole
/// for a side, where no pin moves; jaws for any row or column where pins move, and a bar for another; where none is
/// pinned, pegs on cords for at most 16 particles.
/// @param holders receives them in place of what it has
/// @par Cost O(particles), allocates for more holders than before
void hang(const FrameView& view, std::vector<Holder>& holders);

}  // namespace drape
