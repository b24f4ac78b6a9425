#pragma once

#include <variant>

#include "drape/bounds/aabb.h"
#include "drape/bounds/kdop.h"
#include "drape/bounds/obb.h"
#include "drape/bounds/quadtree_nodes.h"

namespace drape {

/// Any volume that a node may have.
using AnyVolume = std::variant<BoundingSphere, Aabb, KDop<6>, KDop<14>, KDop<18>, KDop<26>, Obb>;

/// A node as a hierarchy shows it.
struct NodeView {
    QuadtreeNode cells;
    NodeVisit visit;   ///< the most that a query since the last build did
    AnyVolume volume;  ///< as fitted: `BroadPhase::slack` is to be added
};

}  // namespace drape
