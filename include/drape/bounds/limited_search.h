#pragma once

#include <cstdint>

#include "drape/bounds/bounding_sphere.h"

namespace drape {

/// Where a search may end before the leaves: the nodes whose children it has not visited then stand for what they hold,
/// as spheres. @cite hubbard1996
struct SearchLimit {
    static constexpr int all_levels = 30;
    int level = all_levels;  ///< the children of nodes of this level are not visited
    std::int64_t tests = 0;  ///< volume tests after which no children are visited; 0: no end

    [[nodiscard]] bool none() const { return level >= all_levels && tests == 0; }
    bool operator==(const SearchLimit&) const = default;
};

/// A node at which a search ended.
struct StoppedNode {
    BoundingSphere sphere;
    int cell = 0;                        ///< in the middle of it
    int i0 = 0, j0 = 0, i1 = 0, j1 = 0;  ///< its cells: columns [i0, i1), rows [j0, j1)
};

}  // namespace drape
