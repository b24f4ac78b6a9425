#pragma once

#include <vector>

#include "drape/bounds/broad_phase.h"

namespace drape {

/// How large nodes are beside the smallest volumes of their kind about the same particles: 1 is as tight as can be.
/// Sizes are radii of spheres, and the mean half width of other volumes between their pairs of faces; what a tree has
/// to be grown by, because it was not fitted again, counts. The smallest sphere is Welzl's; boxes and k-DOPs that are
/// fitted to particles are the smallest; of turned boxes only the one along the patch's mean directions is known.
struct Tightness {
    double sum = 0;  ///< of the ratios
    std::int64_t nodes = 0;

    [[nodiscard]] double mean() const { return sum / static_cast<double>(nodes); }
    Tightness& operator+=(const Tightness& other);
};

/// Adds the nodes of a hierarchy, as last built, to the sums of their levels. Nothing for brute force.
/// @param x to which it was built
/// @param levels grows to as many as there are
/// @par Cost a fit of every node, by Welzl's method for spheres
void add_tightness(const BroadPhase& hierarchy, const Grid& grid, const Points& x, std::vector<Tightness>& levels);

/// All levels together.
Tightness over_levels(const std::vector<Tightness>& levels);

}  // namespace drape
