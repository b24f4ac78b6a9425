#include "pareto_front.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace drape {

std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points) {
    std::vector<std::size_t> by_error(points.size());
    std::iota(by_error.begin(), by_error.end(), std::size_t{0});
    std::ranges::stable_sort(by_error, {}, [&points](std::size_t i) { return points[i]; });
    std::vector<std::size_t> front;
    double cheapest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : by_error) {
        if (!(points[i].second < cheapest)) continue;
        cheapest = points[i].second;
        front.push_back(i);
    }
    return front;
}

}  // namespace drape
