#include "power_law.h"

#include <cmath>

#include "drape/base/assert.h"

namespace drape {

PowerLaw fit_power_law(std::span<const std::pair<double, double>> points) {
    const auto n = static_cast<double>(points.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (const auto& [x, y] : points) mean_x += std::log(x) / n, mean_y += std::log(y) / n;
    for (const auto& [x, y] : points) {
        xx += (std::log(x) - mean_x) * (std::log(x) - mean_x);
        xy += (std::log(x) - mean_x) * (std::log(y) - mean_y);
    }
    DRAPE_ASSERT(xx > 0);
    const double exponent = xy / xx;
    return {std::exp(mean_y - exponent * mean_x), exponent};
}

}  // namespace drape
