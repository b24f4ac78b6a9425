#pragma once

#include <span>

#include "drape/contact/near_pairs.h"

namespace drape {

/// How many times an edge of one cloth crosses a triangle of the other, or, of one cloth, a triangle that it shares no
/// particle with: from one side to the other, through its inside. As a rule, two triangles that cross count twice.
/// What only touches, as far as rounding tells, does not count.
/// @param leaves where cells may meet, as a query for pairs of these two cloths found
/// @par Cost O(pairs of cells in the leaves)
std::int64_t count_crossings(const BoxedCloth& first, const BoxedCloth& second, std::span<const LeafPair> leaves);

}  // namespace drape
