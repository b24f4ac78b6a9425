#pragma once

#include <span>

#include "drape/bounds/node_view.h"

namespace drape {

/// Fits the volume of each of these nodes to its own particles, as a hierarchy of these parameters does that is rebuilt
/// node by node. Does nothing for brute force.
/// @param x n x 3 [m]
/// @par Cost O(particles) for the nodes of one level
void refit_nodes(const BroadPhaseParameters& parameters, const Grid& grid, const Points& x, std::span<NodeView> nodes);

}  // namespace drape
