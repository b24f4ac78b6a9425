#pragma once

#include <Eigen/Geometry>

#include "drape/base/real.h"

namespace exercise_12 {

/// Whether the segment from p to q goes through the inside of the triangle a, b, c, from one side to the other.
inline bool crosses(const drape::Vec3& p, const drape::Vec3& q, const drape::Vec3& a, const drape::Vec3& b,
                    const drape::Vec3& c) {
    (void)p, (void)q, (void)a, (void)b, (void)c;
    return false;  // your turn
}

}  // namespace exercise_12
