#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drape/sim/frame_view.h"

namespace drape {

/// A particle as the shaders take it.
struct ClothVertex {
    float position[3];
    float normal[3];  ///< of length 1, on the front's side
    float pinned;     ///< 1 or 0
};

/// The cloth as drawn: particles between their last two places, with smooth normals.
/// @param vertices receives one a particle
/// @par Cost O(n), allocates nothing
void fill_cloth_vertices(const ClothView& cloth, Real blend, ClothVertex* vertices);

/// Appends the triangles of a grid, three indices each, counter-clockwise on the front.
void append_triangle_indices(const Grid& grid, std::uint32_t first_vertex, std::vector<std::uint32_t>& indices);

/// The ends of all springs of some cloths, two indices each, kind by kind.
struct SpringIndices {
    std::vector<std::uint32_t> structural, shear, bend;
};
void append_spring_indices(const Grid& grid, std::uint32_t first_vertex, SpringIndices& springs);

}  // namespace drape
