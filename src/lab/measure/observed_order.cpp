#include "observed_order.h"

#include <algorithm>
#include <cmath>

#include "drape/base/exact_math.h"
#include "power_law.h"

namespace drape {

std::optional<ObservedOrder> observed_order(std::span<const std::pair<double, double>> points) {
    constexpr std::size_t fewest = 3;
    if (points.size() < fewest) return std::nullopt;
    const auto slope_at = [points](std::size_t i) {
        return natural_log(points[i].second / points[i + 1].second) /
               natural_log(points[i].first / points[i + 1].first);
    };
    const auto differ = [](double a, double b) { return std::abs(a - b) / std::max({1.0, a, b}); };
    std::size_t count = fewest;
    if (!(differ(slope_at(points.size() - 2), slope_at(points.size() - 3)) <= 0.5)) return std::nullopt;
    double order = fit_power_law(points.last(count)).exponent;
    while (count < points.size() && differ(slope_at(points.size() - count - 1), order) <= 0.15) {
        order = fit_power_law(points.last(++count)).exponent;
    }
    return ObservedOrder{order, count};
}

}  // namespace drape
