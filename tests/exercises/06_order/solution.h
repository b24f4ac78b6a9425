#pragma once

#include <Eigen/Core>
#include <vector>

namespace exercise_06 {

inline double observed_order(const std::vector<double>& steps, const std::vector<double>& errors) {
    const auto n = static_cast<Eigen::Index>(steps.size());
    const Eigen::ArrayXd h = Eigen::Map<const Eigen::ArrayXd>(steps.data(), n).log();
    const Eigen::ArrayXd e = Eigen::Map<const Eigen::ArrayXd>(errors.data(), n).log();
    return ((h - h.mean()) * (e - e.mean())).sum() / (h - h.mean()).square().sum();
}

}  // namespace exercise_06
