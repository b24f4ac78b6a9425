#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drape/contact/near_pairs.h"

namespace drape::test {

/// How many pairs of features in two rectangles of cells of one cloth, or in one, are within what they reach.
/// @param x n x 3 [m]
/// @param reaches of each particle [m]
inline std::size_t pairs_within_reach(const Grid& grid, const Points& x, const CellRange& first,
                                      const CellRange& second, std::span<const Real> reaches) {
    CellBoxes boxes;
    boxes.build(grid, x, reaches);
    std::vector<NearPair> pairs;
    const BoxedCloth cloth{.cloth = {0, grid, x}, .boxes = boxes, .reaches = reaches};
    const LeafPair leaves{first, second};
    find_near_pairs(cloth, cloth, {&leaves, 1}, pairs);
    return pairs.size();
}

}  // namespace drape::test
