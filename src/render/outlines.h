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

/// Appends a volume as it is. Edges of boxes without length are left out, and edges of k-DOPs much shorter than the
/// whole.
/// @par Cost of a k-DOP O(slabs^3)
void append_outline(const AnyVolume& volume, NodeState state, Outlines& outlines);

}  // namespace drape
