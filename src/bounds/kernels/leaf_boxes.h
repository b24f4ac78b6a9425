#pragma once

#include <span>

#include "drape/bounds/aabb.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape::kernels {

/// Fits boxes to leaves as `Aabb::fit` does, to the bit, many at a time: particles are read in the order in which they
/// are in memory.
/// @param leaves numbers of nodes, best row by row
/// @param boxes receives those of the leaves; one a node
/// @par Cost O(particles), one pass
void fit_leaf_boxes(const Grid& grid, std::span<const QuadtreeNode> nodes, std::span<const int> leaves, const Points& x,
                    std::span<Aabb> boxes);

}  // namespace drape::kernels
