#pragma once

#include <vector>

#include "drape/bounds/bounding_volume.h"

namespace drape {

/// The largest distance of a particle from where it was before, max |x_p - before_p|, grown by the rounding [m].
/// @par Cost O(particles), one pass over both
Real largest_displacement(const Points& x, const Points& before);

/// For each leaf of a quadtree, the positions to which it was last fitted. Leaves share the particles on their borders,
/// and may be fitted at different times: each has its own copy.
class LeafCopies {
public:
    /// @param leaf number of the node
    /// @param patch its particles now
    void take(std::size_t leaf, const Patch& patch);

    /// The largest distance of a leaf's particles from where the copy has them, grown by the rounding [m].
    [[nodiscard]] Real displacement(std::size_t leaf, const Patch& patch) const;

private:
    std::vector<Points> copies_;  ///< of each leaf's particles, row by row; empty for other nodes
};

}  // namespace drape
