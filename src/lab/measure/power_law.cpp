#include "power_law.h"

#include "drape/base/assert.h"
#include "drape/base/exact_math.h"

namespace drape {

PowerLaw fit_power_law(std::span<const std::pair<double, double>> points) {
    const auto n = static_cast<double>(points.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (const auto& [x, y] : points) mean_x += natural_log(x) / n, mean_y += natural_log(y) / n;
    for (const auto& [x, y] : points) {
        xx += (natural_log(x) - mean_x) * (natural_log(x) - mean_x);
        xy += (natural_log(x) - mean_x) * (natural_log(y) - mean_y);
    }
    DRAPE_ASSERT(xx > 0);
    const double exponent = xy / xx;
    return {exponential(mean_y - exponent * mean_x), exponent};
}

}  // namespace drape
