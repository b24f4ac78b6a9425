#pragma once

#include <span>
#include <utility>

namespace drape {

/// y = factor x^exponent.
struct PowerLaw {
    double factor = 0, exponent = 0;
};

/// The power law that is nearest to some points by least squares of the logarithms: a straight line on paper with two
/// logarithmic axes.
/// @param points (x, y), all positive; at least two of different x
PowerLaw fit_power_law(std::span<const std::pair<double, double>> points);

}  // namespace drape
