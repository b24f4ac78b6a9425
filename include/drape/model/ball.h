#pragma once

#include "drape/base/real.h"

namespace drape {

/// A rigid sphere.
struct Ball {
    Vec3 centre = Vec3::Zero();    ///< [m]
    Real radius = Real(0.3);       ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

}  // namespace drape
