#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "drape/base/real.h"

namespace drape {

/// What the last query did with a node.
enum class NodeState : std::uint8_t { Unvisited, Pruned, Visited, Leaf, Touching };

/// Nodes as they are drawn, in the true shape of their volumes: spheres, and the edges of bodies with flat faces.
struct Outlines {
    struct Sphere {
        Vec3 centre;
        Real radius;
        NodeState state;
    };
    struct Edge {
        Vec3 from, to;
        NodeState state;
    };
    std::vector<Sphere> spheres;
    std::vector<Edge> edges;

    void clear() {
        spheres.clear();
        edges.clear();
    }
};

/// Three directions of length 1, each at right angles to the others, as columns.
using BoxAxes = Eigen::Matrix<Real, 3, 3>;

/// The points origin + axes t with low <= t <= high.
struct BoxShape {
    Vec3 origin;
    BoxAxes axes;
    Vec3 low, high;
};

/// Appends the twelve edges of a box; those without length are left out.
void append_box(const BoxShape& box, NodeState state, Outlines& outlines);

/// The points p with low <= axis . p <= high.
struct Slab {
    std::array<int, 3> axis;
    Real low, high;
};

/// Appends the edges of what slabs have in common. Edges much shorter than the whole are left out.
/// @pre the first three are along the axes of space, so that they enclose it
/// @par Cost O(slabs^3)
void append_polytope(std::span<const Slab> slabs, NodeState state, Outlines& outlines);

}  // namespace drape
