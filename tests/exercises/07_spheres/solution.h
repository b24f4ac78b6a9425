#pragma once

#include "drape/bounds/bounding_sphere.h"

namespace exercise_07 {

inline drape::BoundingSphere enclosing(const drape::BoundingSphere& a, const drape::BoundingSphere& b) {
    const drape::Vec3 offset = b.centre - a.centre;
    const drape::Real distance = offset.norm();
    if (distance + b.radius <= a.radius) return a;
    if (distance + a.radius <= b.radius) return b;
    const drape::Real radius = (distance + a.radius + b.radius) / 2;
    return {a.centre + (radius - a.radius) / distance * offset, radius};
}

}  // namespace exercise_07
