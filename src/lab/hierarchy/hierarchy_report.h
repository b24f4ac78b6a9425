#pragma once

#include "hierarchy_row.h"
#include "lab/measure/fits.h"

namespace drape {

/// The frame from which on, and to the last, one way has cost more in all than another.
/// @param costs of each frame of the way that is cheap at first
/// @param others of the other way, as many
/// @return counted from 0; nothing if it has not cost more when the last frame ends
std::optional<std::size_t> break_even_frame(std::span<const double> costs, std::span<const double> others);

/// How times grow with the number of particles, for one hierarchy.
struct Growth {
    std::string volume, update;
    PowerLaw build, search;  ///< the search is query and exact test
};

/// Fitted over the larger cloths, from the geometric middle of the smallest and the largest on, where what a call costs
/// at the least no longer counts. Hierarchies with fewer than two such sizes are left out.
/// @param rows of the part "size"
std::vector<Growth> growths(const std::vector<HierarchyRow>& rows);

/// A line or more a part.
std::string hierarchy_summary(const std::vector<HierarchyRow>& rows);

/// Charts of the parts that the rows have.
std::vector<Chart> hierarchy_charts(const std::vector<HierarchyRow>& rows);

}  // namespace drape
