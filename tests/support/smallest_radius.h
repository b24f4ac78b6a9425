#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <vector>

#include "drape/base/real.h"

namespace drape::test {

inline Real farthest_distance(const Points& x, const Vec3& centre) {
    return (x.rowwise() - centre.transpose()).rowwise().norm().maxCoeff();
}

/// The radius of the smallest sphere about a few points: of all spheres through two, three or four of them, centred
/// among those, the smallest once it reaches all.
inline Real smallest_radius_by_trying_all(const Points& x) {
    const int n = static_cast<int>(x.rows());
    Real best = farthest_distance(x, x.row(0).transpose());
    const auto try_support = [&](const std::vector<int>& support) {
        const Eigen::Index others = static_cast<Eigen::Index>(support.size()) - 1;
        Points sides(others, 3);
        for (Eigen::Index k = 0; k < others; ++k) {
            sides.row(k) = x.row(support[static_cast<std::size_t>(k) + 1]) - x.row(support[0]);
        }
        const Vec3 out = sides.completeOrthogonalDecomposition().solve(sides.rowwise().squaredNorm() / 2);
        if (out.allFinite()) best = std::min(best, farthest_distance(x, x.row(support[0]).transpose() + out));
    };
    for (int a = 0; a < n; ++a) {
        for (int b = a + 1; b < n; ++b) {
            try_support({a, b});
            for (int c = b + 1; c < n; ++c) {
                try_support({a, b, c});
                for (int d = c + 1; d < n; ++d) try_support({a, b, c, d});
            }
        }
    }
    return best;
}

}  // namespace drape::test
