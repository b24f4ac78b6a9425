#pragma once

#include <cmath>

#include "drape/base/real.h"

namespace exercise_10 {

inline drape::Real longest_step(drape::Real k, drape::Real m, drape::Real zeta) {
    return 2 * (std::sqrt(1 + zeta * zeta) - zeta) * std::sqrt(m / k);
}

}  // namespace exercise_10
