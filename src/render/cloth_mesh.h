#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include "drape/sim/frame_view.h"

namespace drape {

/// A particle as the shaders take it.
struct ClothVertex {
    Eigen::Vector3f position;
    Eigen::Vector3f normal;  ///< of length 1, on the front's side
    float pinned;            ///< 2 in the hand, else 1 or 0
    float value;             ///< that colours the cloth, if one does
    float hollow;            ///< how deep in a fold of the front, in [-1, 1]

    /// Where it is in the cloth, laid out flat, and how large that is; of a solid's point, where it is in its own
    /// frame [m].
    std::array<float, 4> place;
    float number;  ///< of the cloth, or the solid's kind
};

/// The cloth as drawn: particles between their last two positions, with smooth normals, and how deep they are in folds,
/// from the curvature of the cloth as it is drawn; 0 at its edges.
/// @param number of the cloth
/// @param vertices receives one a particle
/// @par Cost O(n), allocates nothing
void fill_cloth_vertices(const ClothView& cloth, int number, Real blend, ClothVertex* vertices);

/// Keeps what is drawn of the items of a view.
/// @param drawn_of what that is of an item
/// @return false if `kept` had it already
template <class Item, class Drawn, class DrawnOf>
bool update_kept(std::span<const Item> items, std::vector<Drawn>& kept, DrawnOf drawn_of) {
    if (std::ranges::equal(items, kept, {}, drawn_of)) return false;
    kept.clear();
    std::ranges::transform(items, std::back_inserter(kept), drawn_of);
    return true;
}

inline Grid grid_of(const ClothView& cloth) { return cloth.model.grid; }

/// The triangles of grids whose particles follow one another, three indices each, counter-clockwise on the front. The
/// last corner of both triangles of a cell is its corner b.
std::vector<std::uint32_t> triangle_indices(std::span<const Grid> grids);

/// The ends of all their springs, two indices each: the structural ones, those of shear, and those of bend.
struct SpringIndices {
    std::vector<std::uint32_t> ends;
    std::array<int, 3> counts;  ///< of springs of each kind
};
SpringIndices spring_indices(std::span<const Grid> grids);

}  // namespace drape
