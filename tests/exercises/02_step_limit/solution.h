#pragma once

#include <cmath>

#include "drape/base/real.h"

namespace exercise_02 {

inline drape::Real longest_step(drape::Real k, drape::Real d) { return 4 / (d + std::sqrt(d * d + 4 * k)); }

}  // namespace exercise_02
