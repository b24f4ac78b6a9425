#pragma once

#include "drape/base/real.h"

namespace exercise_05 {

/// By how much one correction changes the multiplier of a spring, whose ends then move by w_a and -w_b times as much.
/// @param c elongation [m], q the multiplier so far [kg m], compliance 1/k [m/N], h step [s]
/// @param w_a, w_b inverse masses of the ends [1/kg]
/// @return [kg m]
inline drape::Real change(drape::Real c, drape::Real q, drape::Real compliance, drape::Real h, drape::Real w_a,
                          drape::Real w_b) {
    (void)c, (void)q, (void)compliance, (void)h, (void)w_a, (void)w_b;
    return 0;  // your turn
}

}  // namespace exercise_05
