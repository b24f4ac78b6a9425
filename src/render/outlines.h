#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drape/bounds/node_view.h"

namespace drape {

/// How a node is drawn: by what queries did with it, and whether anything in it touches. The order is that of the
/// shader's colours.
enum class NodeState : std::uint8_t { Unvisited, Pruned, Entered, Leaf, Touching };

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

/// Appends nodes of a hierarchy. Spheres are drawn grown by its slack [m]; of other volumes the faces are as fitted.
/// @param touched_cells cells with a contact
void append_nodes(std::span<const NodeView> nodes, Real slack, const Grid& grid, std::span<const int> touched_cells,
                  Outlines& outlines);

void append_outline(const BoundingSphere& sphere, NodeState state, Outlines& outlines);

/// The edges of a box; those without length are left out.
void append_outline(const Aabb& box, NodeState state, Outlines& outlines);
void append_outline(const Obb& box, NodeState state, Outlines& outlines);

/// The edges of what its slabs have in common. Edges much shorter than the whole are left out.
/// @par Cost O(slabs^3)
template <int K>
void append_outline(const KDop<K>& dop, NodeState state, Outlines& outlines);

}  // namespace drape
