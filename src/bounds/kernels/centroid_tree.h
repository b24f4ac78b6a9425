#pragma once

#include <span>

#include "drape/bounds/bounding_sphere.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape::kernels {

/// Fits a centroid sphere to all particles of each node of a quadtree, all levels in one pass over the particles: a
/// node's mean is made from the sums of its leaves, and while a leaf's particles are at hand, their distances from the
/// centres of all nodes above it are taken. The radii are those of the fit node by node about the same centres, bit for
/// bit; the centres differ from its by rounding.
/// @param spheres one a node
/// @par Cost O(particles * levels), memory read twice
void fit_centroid_tree(const Grid& grid, std::span<const QuadtreeNode> nodes, const Points& x,
                       std::span<BoundingSphere> spheres);

}  // namespace drape::kernels
