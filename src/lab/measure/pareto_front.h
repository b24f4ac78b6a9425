#pragma once

#include <span>
#include <utility>
#include <vector>

namespace drape {

/// Those of some points that no other one beats: none is at most as large in both numbers.
/// @param points (error, cost); of equal ones the first counts
/// @return their numbers, with falling cost
/// @par Cost O(n log n)
std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points);

}  // namespace drape
