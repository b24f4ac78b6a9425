#pragma once

#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "drape/bounds/bounding_volume.h"
#include "support/cloths.h"

namespace drape::test {

/// All rows of positions as one patch of a single row.
inline Patch patch_of_points(const Points& x) {
    const int n = static_cast<int>(x.rows());
    return {x.col(0).data(), x.col(1).data(), x.col(2).data(), n, 1, n};
}

/// A way to throw n points, about one metre about the origin.
struct PointSet {
    std::string name;
    std::function<Vec3(std::mt19937&)> point;
};

/// Random sets that a fit must hold out, the degenerate ones included.
inline std::vector<PointSet> point_sets() {
    const auto cube = [](std::mt19937& random) {
        std::uniform_real_distribution<Real> unit(-1, 1);
        const Real x = unit(random), y = unit(random), z = unit(random);
        return Vec3(x, y, z);
    };
    const auto gaussian = [](std::mt19937& random) {
        std::normal_distribution<Real> normal(0, 1);
        const Real x = normal(random), y = normal(random), z = normal(random);
        return Vec3(x, y, z);
    };
    const auto circle = [cube](std::mt19937& random) {
        const Real angle = std::numbers::pi_v<Real> * cube(random)[0];
        return Vec3(Vec3(2, 1, 0).normalized() * std::cos(angle) + Vec3(0, 0, 1) * std::sin(angle));
    };
    return {{"cube", cube},
            {"gaussian", gaussian},
            {"ball surface", [gaussian](std::mt19937& random) { return gaussian(random).normalized().eval(); }},
            {"one point", [](std::mt19937&) { return Vec3(Real(0.1), Real(0.2), Real(0.3)); }},
            {"two points",
             [cube](std::mt19937& random) { return Vec3(cube(random)[0] < 0 ? Vec3(1, 2, 3) : Vec3(-1, 0, 5)); }},
            {"line", [cube](std::mt19937& random) { return Vec3(Vec3(1, 2, 3) * cube(random)[0] / 3); }},
            {"plane", [cube](std::mt19937& random) { return Vec3(cube(random).cwiseProduct(Vec3(1, 0, 1))); }},
            {"circle", circle},
            {"arc", [circle](std::mt19937& random) { return Vec3(circle(random).cwiseAbs()); }}};
}

inline Points random_points(const PointSet& set, int n, std::mt19937& random) {
    Points x(n, 3);
    for (int p = 0; p < n; ++p) x.row(p) = set.point(random).transpose();
    return x;
}

}  // namespace drape::test
