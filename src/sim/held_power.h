#pragma once

#include "drape/model/cloth_model.h"
#include "drape/model/forces.h"

namespace drape {

/// The energy a second that whatever moves a held particle puts in at a moment [W]: the work against the forces of
/// springs, air and gravity on that particle; less than zero where they pull it along.
inline double held_power(const ClothModel& model, const ClothState& state, int particle) {
    return -static_cast<double>(force_on(model, state.x, state.v, particle).dot(state.v.row(particle)));
}

}  // namespace drape
