#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "drape/base/assert.h"
#include "drape/base/exact_math.h"

namespace drape {
namespace {

double seconds_of(clockid_t clock) {
    std::timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The exponent of the power law y = c x^p that is nearest to some points by least squares of the logarithms: a
/// straight line on paper with two logarithmic axes.
/// @param points (x, y), all positive; at least two of different x
double fitted_exponent(std::span<const std::pair<double, double>> points) {
    const auto n = static_cast<double>(points.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (const auto& [x, y] : points) mean_x += natural_log(x) / n, mean_y += natural_log(y) / n;
    for (const auto& [x, y] : points) {
        xx += (natural_log(x) - mean_x) * (natural_log(x) - mean_x);
        xy += (natural_log(x) - mean_x) * (natural_log(y) - mean_y);
    }
    DRAPE_ASSERT(xx > 0);
    return xy / xx;
}

}  // namespace

Quartiles quartiles_of(std::vector<double> values) {
    DRAPE_ASSERT(!values.empty());
    std::sort(values.begin(), values.end());
    const auto at = [&values](double part) {
        const double rank = part * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(rank), above = std::min(below + 1, values.size() - 1);
        return std::lerp(values[below], values[above], rank - std::floor(rank));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

double thread_cpu_time() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

double program_cpu_time() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

std::optional<double> observed_order(std::span<const std::pair<double, double>> points) {
    constexpr std::size_t fewest = 3;
    if (points.size() < fewest) return std::nullopt;
    const auto slope_at = [points](std::size_t i) {
        return natural_log(points[i].second / points[i + 1].second) /
               natural_log(points[i].first / points[i + 1].first);
    };
    const auto differ = [](double a, double b) { return std::abs(a - b) / std::max({1.0, a, b}); };
    std::size_t count = fewest;
    if (!(differ(slope_at(points.size() - 2), slope_at(points.size() - 3)) <= 0.5)) return std::nullopt;
    double order = fitted_exponent(points.last(count));
    while (count < points.size() && differ(slope_at(points.size() - count - 1), order) <= 0.15) {
        order = fitted_exponent(points.last(++count));
    }
    return order;
}

}  // namespace drape
