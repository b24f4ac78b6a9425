#pragma once

#include <Eigen/Geometry>

#include "drape/base/real.h"

namespace exercise_12 {

/// Six times the volume of the tetrahedron a, b, c, d: its sign is the side of a, b, c that d is on.
inline drape::Real side(const drape::Vec3& a, const drape::Vec3& b, const drape::Vec3& c, const drape::Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
}

inline bool crosses(const drape::Vec3& p, const drape::Vec3& q, const drape::Vec3& a, const drape::Vec3& b,
                    const drape::Vec3& c) {
    const drape::Real ab = side(p, q, a, b), bc = side(p, q, b, c), ca = side(p, q, c, a);
    return side(a, b, c, p) * side(a, b, c, q) < 0 && ab * bc > 0 && bc * ca > 0;
}

}  // namespace exercise_12
