#pragma once

#include <optional>
#include <string>

#include "drape/render/camera.h"
#include "drawn_nodes.h"

namespace drape {

/// A node under the pointer, and why it is what it is.
struct NodePick {
    std::size_t cloth = 0;
    int number = 0;  ///< among the nodes of its level
    NodeView node;
    NodeState state{};
    bool at_ball = false;  ///< a ball overlaps its volume, thickness and slack counted
};

/// Finds the node of the cloth under the pointer: of the shown level, or of the leaves where all are shown.
/// @param x, y of the pointer, from the upper left [pixel]
/// @par Cost O(nodes shown + triangles)
std::optional<NodePick> pick_node(const FrameView& view, const Camera& camera, int x, int y, int width, int height);

/// "Level 3, node 21: columns 8-15, rows 0-7", of cells; with several cloths, which.
std::string node_title(const NodePick& pick, const FrameView& view);

/// "pruned: no ball overlaps it"
std::string node_reason(const NodePick& pick, const FrameView& view);

}  // namespace drape
