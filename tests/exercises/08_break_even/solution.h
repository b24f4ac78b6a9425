#pragma once

#include <cmath>

#include "drape/base/real.h"

namespace exercise_08 {

inline int frames_between_rebuilds(drape::Real rebuild, drape::Real growth) {
    // One frame more pays while n (n + 1) growth / 2 < rebuild
    int n = 1;
    while (n * (n + drape::Real(1)) * growth / 2 < rebuild) ++n;
    return n;
}

}  // namespace exercise_08
