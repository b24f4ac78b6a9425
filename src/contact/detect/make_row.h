#pragma once

#include "contact/contact_geometry.h"
#include "drape/contact/detection.h"

namespace drape {

/// The contact of a particle with a body, without a plane yet.
/// @param triangle that reports it
inline ContactRow particle_row(const MovingCloth& cloth, int particle, int triangle, int body) {
    ContactRow row;
    row.kind = RowKind::Particle;
    row.count = row.first_count = 1;
    row.triangle = triangle;
    row.body = body;
    row.particles[0] = {cloth.number, particle, 1};
    return row;
}

/// The same of a point in a triangle, or on an edge.
inline ContactRow triangle_row(const MovingCloth& cloth, int triangle, const std::array<int, 3>& corners,
                               const std::array<Real, 3>& weights, int body) {
    ContactRow row;
    row.kind = RowKind::Triangle;
    row.count = row.first_count = 3;
    row.triangle = triangle;
    row.body = body;
    for (std::size_t k = 0; k < 3; ++k) row.particles[k] = {cloth.number, corners[k], weights[k]};
    return row;
}

/// The corners of a triangle in the order of their numbers: those of a cell's first one are a, c, b.
inline constexpr std::array<std::size_t, 3> corners_ascending{0, 2, 1};

}  // namespace drape
