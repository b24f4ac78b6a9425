#pragma once

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/contact/body.h"
#include "drape/contact/contact_row.h"
#include "drape/model/ball.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// A cloth, where it is, and where it was at the start of the substep.
struct MovingCloth {
    const Grid& grid;
    const Points &before, &x;  ///< n x 3 [m]
    int number = 0;            ///< among all cloths
};

/// The body that a search looks for.
struct SearchedBody {
    int number = 0;
    Real thickness = 0;  ///< of the cloth [m]
    /// By how much it and cloth may have come nearer to each other within the substep. Then planes are those of its
    /// start, when they were on the right sides of each other, and go on with the body: what passes through has come
    /// past its plane, and is found like all else. 0: planes are those of the end, on which cloth lies more calmly [m]
    Real reach = 0;
};

/// The touched triangles, exactly: those whose distance to the ball's centre is at most radius + thickness.
/// @param x n x 3 [m]
/// @param cells candidate cells
/// @param triangles receives the triangle numbers, in the order of `cells`; cleared first
void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const CellRange> cells, std::vector<int>& triangles, Kernels kernels);

/// The contacts of the candidate cells with one ball, appended: each particle, each edge and each triangle at most
/// once. A particle counts if it may come into the grown ball; a triangle, or an edge, if its closest point to the
/// centre may.
/// @param kernels plain: each cell is tested; vector: cells that their corners show to be too far are left out first
/// @return how many of the cells touch at the end, or have come past the plane of the start
std::int64_t find_contacts(const MovingCloth& cloth, const Ball& ball, const SearchedBody& body,
                           std::span<const CellRange> cells, std::vector<ContactRow>& rows, Kernels kernels);

/// How fast a node's sphere may push: as fast as a cloth settles, and slower than it tears [m/s].
inline constexpr Real node_push_speed = 1;

/// The contacts of nodes at which a search has ended with one ball, appended: of each, a sphere that is fixed to the
/// middle of a triangle in the node's middle, and felt there. @cite hubbard1996
/// Most of a sphere is empty. Pushed out of it at once, the one triangle that feels it would tear at its neighbours:
/// what is deeper than a push may be is taken off the sphere's radius.
/// @param longest_push that one response may make of a contact [m]
void find_node_contacts(const MovingCloth& cloth, const Ball& ball, const SearchedBody& body, Real longest_push,
                        std::span<const StoppedNode> nodes, std::vector<ContactRow>& rows);

/// The contacts of the candidate cells with the ground, appended: particles alone, for whatever is between them is
/// above the lowest.
void find_ground_contacts(const MovingCloth& cloth, Real height, const SearchedBody& body,
                          std::span<const CellRange> cells, std::vector<ContactRow>& rows);

/// Finds where a cloth may touch solids within a substep. A contact is a plane: that of the surface next to a particle,
/// or to the point of a triangle, or of an edge, that is deepest.
class SolidSearch {
public:
    /// The contacts of the candidate cells with one solid, appended: each particle, each edge and each triangle at most
    /// once, triangles ascending.
    /// @param solid at the end of the substep
    /// @param cells ascending
    void find(const MovingCloth& cloth, const Solid& solid, const SearchedBody& body, std::span<const CellRange> cells,
              std::vector<ContactRow>& rows);

    /// A distance of a triangle, and where its corners were, seen from the solid: since then it has changed by no more
    /// than one of these has moved.
    struct Measured {
        std::array<Vec3, 3> corners;
        Real distance = -std::numeric_limits<Real>::infinity();  ///< before there is one
    };

private:
    struct Known {
        std::shared_ptr<const SolidShape> shape;
        std::vector<Measured> triangles;
    };

    std::map<int, Known> known_;            ///< of each solid, by the number of its body
    std::vector<SurfaceDistance> surface_;  ///< of the particles of the cells
};

/// The contacts of balls with each other and with all other bodies, appended, at most one for each two of
/// which one gives way: in the plane where the ball is deepest, or, if it has passed the other within the substep or
/// come to another side, where they have met.
/// @param bodies the balls first
/// @param thickness of the cloth: a motor leaves room for two beside what stops it [m]
/// @par Cost O(balls bodies) distances
void find_body_contacts(std::span<const Body> bodies, Real thickness, std::vector<ContactRow>& rows);

/// What a limited search has invented: how many of the nodes at which it has ended give a contact with a ball although
/// no triangle within them touches it.
/// @par Cost O(cells of the nodes): for charts, not for the clock
std::int64_t count_false_contacts(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                                  std::span<const StoppedNode> nodes);

/// And what it has let through: the largest depth of any triangle in any ball, 0 if none touches [m].
/// @par Cost O(cells * balls)
Real deepest_penetration(const Grid& grid, const Points& x, std::span<const Ball> balls, Real thickness);

}  // namespace drape
