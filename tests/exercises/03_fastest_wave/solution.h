#pragma once

#include "drape/model/stencils.h"

namespace exercise_03 {

inline Eigen::Matrix2d wave_stiffness(const drape::ClothModel& model, double a, double b) {
    Eigen::Matrix2d s = Eigen::Matrix2d::Zero();
    for (const auto& [di, dj, law, rest_length] : spring_stencils(model)) {
        const Eigen::Vector2d n = Eigen::Vector2d(di * model.hx, dj * model.hy) / rest_length;
        s += 2 * law.stiffness * (1 - std::cos(a * di + b * dj)) * n * n.transpose();
    }
    return s;
}

}  // namespace exercise_03
