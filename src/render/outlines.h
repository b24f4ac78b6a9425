#pragma once

#include <span>
#include <vector>

#include "node_states.h"

namespace drape {

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
void append_nodes(std::span<const NodeView> nodes, Real slack, const TouchedCells& touched, Outlines& outlines);

void append_outline(const BoundingSphere& sphere, NodeState state, Outlines& outlines);

/// The edges of a box; those without length are left out.
void append_outline(const Aabb& box, NodeState state, Outlines& outlines);
void append_outline(const Obb& box, NodeState state, Outlines& outlines);

/// The edges of what its slabs have in common. Edges much shorter than the whole are left out.
/// @par Cost O(slabs^3)
template <int K>
void append_outline(const KDop<K>& dop, NodeState state, Outlines& outlines);

}  // namespace drape
