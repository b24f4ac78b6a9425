#pragma once

#include "drape/base/real.h"

namespace drape {

/// The horizontal plane that is drawn, and on which things rest where it is solid.
struct Ground {
    Real height = -1;           ///< [m]
    bool solid = true;          ///< cloth and balls stay above it
    Real friction = Real(0.5);  ///< Coulomb coefficient of whatever lies on it
    Real restitution = 0;       ///< of the normal speed
    Real rolling = 0;           ///< resistance to rolling: its torque on a ball is rolling * radius * load
    bool operator==(const Ground&) const = default;
};

}  // namespace drape
