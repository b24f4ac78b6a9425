#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "drape/base/real.h"
#include "drape/bounds/aabb.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape {

/// The least distance at rest of features that share no particle: of a corner of a cell from its diagonal [m].
inline Real apart_at_rest(Real hx, Real hy) { return hx * hy / std::sqrt(hx * hx + hy * hy); }

/// Tells which nodes of a cloth's hierarchy cannot touch themselves, because they are not folded enough: the cone test
/// of @cite volino1994 in a form that is proved for distances and needs no look at a patch's outline.
///
/// A patch is a map phi from a rectangle of the plane, the cloth at rest, into space, linear on each triangle with the
/// derivative F = (e_u / hx, e_v / hy), where e_u and e_v are the triangle's edges along rows and columns. Take any two
/// directions at right angles, the columns of Q. If v.(Q^T F) v >= c |v|^2 on all triangles and for all v, then along
/// the straight line from p to q in the rectangle (q - p).Q^T (phi(q) - phi(p)) >= c |q - p|^2, and so
/// |phi(q) - phi(p)| >= c |q - p|: what is apart at rest stays apart. At rest, features that share no particle are at
/// least `apart_at_rest` apart.
class FoldTest {
public:
    FoldTest() = default;

    /// @param leaf_cells of the cloth's hierarchy: its nodes and these have the same numbers
    FoldTest(const Grid& grid, Real hx, Real hy, int leaf_cells);

    /// Follows the cloth to its present positions.
    /// @param x n x 3 [m]
    /// @param reaches of each particle [m]: what is farther apart than those of its nodes together is apart enough;
    /// empty: only the distance that is asked for counts
    /// @par Cost O(particles)
    void build(const Points& x, std::span<const Real> reaches = {});

    /// Whether all features in a node that share no particle are farther apart than a distance [m], or than they reach.
    [[nodiscard]] bool node_is_separated(int node, Real distance) const;

    /// The same for two nodes which together are a rectangle, or touch at a corner and are a rectangle together with
    /// the other two nodes at that corner; false for all others.
    [[nodiscard]] bool nodes_are_separated(int first, int second, Real distance) const;

private:
    /// All derivatives of a patch are within, and none of its particles reaches farther.
    struct Derivatives {
        Aabb along, across;  ///< e_u / hx, e_v / hy
        Real reach;          ///< [m]

        /// Those of another patch too, but for its reach.
        void include(const Derivatives& other) {
            along.include(other.along);
            across.include(other.across);
        }
    };

    [[nodiscard]] std::array<int, 2> at_corner_of(int first, int second) const;
    [[nodiscard]] Derivatives of_leaf(const QuadtreeNode& leaf, const Points& x, std::span<const Real> reaches) const;
    [[nodiscard]] bool bounds(const Derivatives& derivatives, Real distance) const;

    Grid grid_;
    Real hx_ = 0, hy_ = 0;
    std::vector<QuadtreeNode> nodes_;
    std::vector<int> by_corner_;            ///< numbers of the nodes by level, i0 and j0
    std::vector<Derivatives> derivatives_;  ///< of each node
};

}  // namespace drape
