#pragma once

#include "drape/base/real.h"

namespace exercise_05 {

inline drape::Real change(drape::Real c, drape::Real q, drape::Real compliance, drape::Real h, drape::Real w_a,
                          drape::Real w_b) {
    const drape::Real alpha = compliance / (h * h);
    return -(c + alpha * q) / (w_a + w_b + alpha);
}

}  // namespace exercise_05
