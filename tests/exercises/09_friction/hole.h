#pragma once

#include "drape/contact/contact_row.h"

namespace exercise_09 {

/// A visit of projected Gauss-Seidel to one contact of a block with the ground: changes its total impulse so that the
/// block no longer approaches the ground, nor slides on it if friction can stop it, and its velocity to match.
/// The ground never pulls, and friction is at most mu times the normal impulse. In the formulas of the page, m and m_t
/// are both 1 / inverse_mass here, and v* is 0.
/// @param n from the ground to the block, of length 1
/// @param inverse_mass of the block [1/kg], mu the friction coefficient
/// @param total so far: `normal` along n, `friction` a vector across it; `total.about(n)` is both [N s]
inline void solve_row(const drape::Vec3& n, drape::Real inverse_mass, drape::Real mu, drape::Vec3& velocity,
                      drape::RowImpulse& total) {
    (void)n, (void)inverse_mass, (void)mu, (void)velocity, (void)total;  // your turn
}

}  // namespace exercise_09
