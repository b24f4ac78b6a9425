#pragma once

#include "drape/base/real.h"

namespace exercise_04 {

struct Motion {
    drape::Real x, v;
};

inline Motion backward_euler(const Motion& start, drape::Real k, drape::Real d, drape::Real h) {
    const drape::Real dv = h * (-k * start.x - d * start.v - h * k * start.v) / (1 + h * d + h * h * k);
    return {start.x + h * (start.v + dv), start.v + dv};
}

}  // namespace exercise_04
