#pragma once

#include "drape/model/cloth_model.h"

namespace exercise_01 {

inline drape::Vec3 spring_force(const drape::SpringLaw& law, drape::Real rest_length, const drape::Vec3& d,
                                const drape::Vec3& w) {
    const drape::Vec3 n = d.normalized();
    return -(law.stiffness * (d.norm() - rest_length) + law.damping * n.dot(w)) * n;
}

}  // namespace exercise_01
