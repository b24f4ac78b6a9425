#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "drape/contact/near_pairs.h"

namespace drape {

/// The features of a contact of two cloths.
inline NearPair pair_of(const ContactRow& row) {
    NearPair pair;
    pair.features = {{row.particles[0].cloth, row.particles[3].cloth}, row.first_count, {}};
    for (std::size_t k = 0; k < 4; ++k) pair.features.particles[k] = row.particles[k].particle;
    pair.triangle = row.triangle;
    return pair;
}

/// Where they are nearest.
inline void set_plane(const NearPair& pair, ContactRow& row) {
    for (std::size_t k = 0; k < 4; ++k) row.particles[k].weight = pair.signed_weight(k);
    row.normal = pair.normal;
}

// Cheap proofs, without a division, that two features are farther apart than a distance: along some direction, all of
// one is that far from all of the other. False only means that this direction does not tell. The distance is to have an
// allowance for rounding.

/// With an allowance for the rounding of coordinates up to 10 km.
inline Real with_rounding(Real distance) {
    return distance * Real(1 + 1e-6) + 64 * std::numeric_limits<Real>::epsilon() * Real(1e4);
}

/// Whether a gap along a direction, times the length of that, is more than a distance.
inline bool is_wider(Real gap_times_length, const Vec3& direction, Real distance) {
    return gap_times_length > 0 && gap_times_length * gap_times_length > distance * distance * direction.squaredNorm();
}

/// Along the direction that is at right angles to two others, unless these are nearly parallel: rounding decides then.
inline bool is_wider_across(const Vec3& u, const Vec3& v, const Vec3& offset, Real distance) {
    const Vec3 normal = u.cross(v);
    if (!(normal.squaredNorm() > Real(1e-8) * u.squaredNorm() * v.squaredNorm())) return false;
    return is_wider(std::abs(normal.dot(offset)), normal, distance);
}

/// Of the segments from a to b and from c to d: along the line between their middles, and along their common normal.
inline bool segments_are_apart(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, Real distance) {
    const Vec3 u = b - a, v = d - c, middles = a - c + (u - v) / 2;
    const Real halves = (std::abs(u.dot(middles)) + std::abs(v.dot(middles))) / 2;
    return is_wider(middles.squaredNorm() - halves, middles, distance) || is_wider_across(u, v, a - c, distance);
}

/// Of a point and triangle a, b, c: along the line from the middle of the triangle, and along its normal.
inline bool triangle_is_apart(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, Real distance) {
    const Vec3 of_a = p - a, of_b = p - b, of_c = p - c, middles = of_a + of_b + of_c;
    const Real gap = std::min({of_a.dot(middles), of_b.dot(middles), of_c.dot(middles)});
    return is_wider(gap, middles, distance) || is_wider_across(b - a, c - a, of_a, distance);
}

}  // namespace drape
