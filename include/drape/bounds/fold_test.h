#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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
///
/// Where the columns of F change by at most s each, c falls by at most sqrt(2) s: what is found holds for as long as
/// the cloth changes its shape by no more, however far it moves.
class FoldTest {
public:
    FoldTest() = default;

    /// @param leaf_cells of the cloth's hierarchy: its nodes and these have the same numbers
    FoldTest(const Grid& grid, Real hx, Real hy, int leaf_cells);

    /// Follows the cloth to its present positions.
    /// @param x n x 3 [m]
    /// @par Cost O(particles)
    void build(const Points& x);

    /// The same for a time in which it changes its shape, for as long as `holds`.
    /// @param to where it moves within a substep, n x 3 [m]
    /// @param substeps like that one, which the time is to be long; each leaf gets room for that change
    /// @param apart what features must stay apart by, whatever distance is asked for [m]
    void build(const Points& x, const Points& to, Real substeps, Real apart);

    /// Whether no leaf that was found separated has changed its shape by more than it has room for.
    /// @param from the positions that it was built from, x now
    /// @par Cost O(particles)
    [[nodiscard]] bool holds(const Points& from, const Points& x) const;

    /// Whether all features in a node that share no particle are farther apart than a distance [m].
    [[nodiscard]] bool node_is_separated(int node, Real distance) const;

    /// The same for two nodes which together are a rectangle, or touch at a corner and are a rectangle together with
    /// the other two nodes at that corner; false for all others.
    [[nodiscard]] bool nodes_are_separated(int first, int second, Real distance) const;

private:
    /// All derivatives of a patch are within, and may change by so much.
    struct Derivatives {
        Aabb along, across;  ///< e_u / hx, e_v / hy
        Real change;

        /// Those of another patch too.
        void include(const Derivatives& other) {
            along.include(other.along);
            across.include(other.across);
            change = std::max(change, other.change);
        }
    };

    template <class OfLeaf>
    void build_nodes(OfLeaf of_leaf);
    void give_room(const QuadtreeNode& leaf, Real change);
    [[nodiscard]] std::array<int, 2> at_corner_of(int first, int second) const;
    [[nodiscard]] Derivatives of_leaf(const QuadtreeNode& leaf, const Points& x) const;
    [[nodiscard]] bool bounds(const Derivatives& derivatives, Real distance) const;

    Grid grid_;
    Real hx_ = 0, hy_ = 0;
    std::vector<QuadtreeNode> nodes_;
    std::vector<int> by_corner_;            ///< numbers of the nodes by level, i0 and j0
    std::vector<Derivatives> derivatives_;  ///< of each node
    Real apart_ = 0;
    /// By how much edges from each particle, along and across, may change, squared [m^2]; infinite where no leaf relies
    /// on them
    std::array<std::vector<Real>, 2> room_;
    Points moved_;  ///< scratch
};

}  // namespace drape
