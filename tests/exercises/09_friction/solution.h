#pragma once

#include <algorithm>

#include "drape/contact/contact_row.h"

namespace exercise_09 {

inline void solve_row(const drape::Vec3& n, drape::Real inverse_mass, drape::Real mu, drape::Vec3& velocity,
                      drape::RowImpulse& total) {
    const drape::RowImpulse before = total;
    const drape::Real along = velocity.dot(n);
    total.normal = std::max(before.normal - along / inverse_mass, drape::Real(0));
    total.friction = before.friction - (velocity - along * n) / inverse_mass;
    const drape::Real wanted = total.friction.norm(), bound = mu * total.normal;
    if (wanted > bound) total.friction *= bound / wanted;
    velocity += inverse_mass * (total.about(n) - before.about(n));
}

}  // namespace exercise_09
