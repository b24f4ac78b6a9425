#pragma once

#include "drape/model/cloth_model.h"

namespace exercise_01 {

/// The force of a damped spring on its end a: along the spring, k times the elongation plus c times the speed at which
/// the ends part, and against both. None where d = 0, as the spring has no direction there.
/// @param d x_a - x_b [m], w v_a - v_b [m/s]
/// @return [N]
inline drape::Vec3 spring_force(const drape::SpringLaw& law, drape::Real rest_length, const drape::Vec3& d,
                                const drape::Vec3& w) {
    (void)law, (void)rest_length, (void)d, (void)w;
    return drape::Vec3::Zero();  // your turn
}

}  // namespace exercise_01
