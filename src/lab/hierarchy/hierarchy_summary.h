#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "hierarchy_row.h"
#include "lab/measure/power_law.h"

namespace drape {

/// Rows of one part, read back.
std::vector<HierarchyRow> rows_of_part(const std::vector<TableRow>& rows, const std::string& part);

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
std::string hierarchy_summary(const std::vector<TableRow>& rows);

}  // namespace drape
