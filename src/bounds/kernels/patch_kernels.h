#pragma once

#include <span>

#include "drape/bounds/aabb.h"
#include "drape/bounds/obb.h"
#include "drape/bounds/quadtree_nodes.h"

/// Loops over the particles of a patch, vectorised for several generations of processors, of which the best that there
/// is gets chosen at run time. Smallest and largest values are exact in any order, and sums run in an order that does
/// not depend on the width of the vectors, so that the bits are the same on all of them.
namespace drape::kernels {

/// Sums over a patch of two rows or more, so made that those of neighbours, which share a column or a row, add up to
/// those of both.
struct PatchSums {
    Vec3 inner;  ///< without the last column and row
    Vec3 right;  ///< of the last column without the last particle
    Vec3 below;  ///< of the last row without the last particle

    /// Zero. Written out, for one that the compiler made where it is first used, within a kernel, would be for the
    /// processor of that kernel, and be called on every other.
    PatchSums() : inner(Vec3::Zero()), right(Vec3::Zero()), below(Vec3::Zero()) {}
};

/// Each column is added up row by row, then the columns by eights, then these pairwise.
PatchSums sums(const Patch& patch);

/// Mean of the particles.
inline Vec3 mean(const Patch& patch, const PatchSums& sums) {
    const Vec3 corner = patch.at(patch.columns - 1, patch.rows - 1);
    return (sums.inner + sums.right + (sums.below + corner)) / static_cast<Real>(patch.particles());
}

/// The largest squared distance of a particle from each of several centres; squares[k] is raised to it.
/// @param centres count x 3
void raise_to_farthest(const Patch& patch, const Vec3* centres, int count, Real* squares);

/// Smallest and largest coordinates along the directions of a k-DOP, `dop_numbers<2 * slabs>`, by sums alone; those of
/// 3 slabs are the axes.
/// @param low, high receive `slabs` each
void dop_extents(const Patch& patch, int slabs, Real* low, Real* high);

/// The same along three directions, measured from a point.
/// @param low, high receive 3 each
void extents_along(const Patch& patch, const Vec3& origin, const BoxAxes& axes, Real* low, Real* high);

/// Fits a centroid sphere to all particles of each node of a quadtree, all levels in one pass over the particles: a
/// node's mean is made from the sums of its leaves, and while a leaf's particles are at hand, their distances from the
/// centres of all nodes above it are taken. The radii are those of the fit node by node about the same centres, bit for
/// bit; the centres differ from its by rounding.
/// @param spheres one a node
/// @par Cost O(particles * levels), memory read twice
void fit_centroid_tree(const Grid& grid, std::span<const QuadtreeNode> nodes, const Points& x,
                       std::span<BoundingSphere> spheres);

}  // namespace drape::kernels
