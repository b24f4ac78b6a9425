#pragma once

#include <span>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/contact/detection.h"

namespace drape {

/// Measures what a limited search gets wrong, by testing every cell exactly: for charts, not for the clock.
class SearchAudit {
public:
    SearchAudit(const Grid& grid, Kernels kernels);

    /// How many of the nodes give a contact although no triangle within them touches the ball.
    /// @param nodes at which the search for this ball has ended
    /// @par Cost O(cells + nodes * touched triangles)
    std::int64_t false_contacts(const Points& x, const Ball& ball, Real thickness, std::span<const StoppedNode> nodes);

    /// The largest depth of any triangle in any ball, 0 if none touches [m].
    /// @par Cost O(cells * balls)
    Real penetration(const Points& x, std::span<const Ball> balls, Real thickness);

private:
    Grid grid_;
    Kernels kernels_;
    std::vector<CellRun> cells_;  ///< all there are
    std::vector<int> triangles_;
    std::vector<ContactRow> rows_;
};

}  // namespace drape
