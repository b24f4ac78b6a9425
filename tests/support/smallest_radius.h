#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
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

/// A radius below which no sphere holds all points, close to that of the smallest if `centre` is its centre. For any
/// weights w of sum 1, no radius is below sqrt(sum w |p|^2 - |sum w p|^2); the weights are sought that bring the mean
/// of the farthest points to the centre, which must be among them.
inline Real lower_bound_of_radius(const Points& x, const Vec3& centre) {
    const Real reach = farthest_distance(x, centre);
    std::vector<Vec3> rim;
    for (Eigen::Index p = 0; p < x.rows(); ++p) {
        const Vec3 out = x.row(p).transpose() - centre;
        if (out.norm() >= reach * (1 - Real(1e-10))) rim.push_back(out);
    }
    std::vector<Real> weight(rim.size(), 0);
    weight[0] = 1;
    Vec3 mean = rim[0];
    for (int round = 0; round < 2'000'000 && mean.norm() > Real(1e-7) * reach; ++round) {
        // From the point with weight that is farthest along the mean to the one that is farthest against it
        std::size_t from = 0, to = 0;
        Real most = -std::numeric_limits<Real>::max(), least = -most;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const Real along = rim[k].dot(mean);
            if (weight[k] > 0 && along > most) most = along, from = k;
            if (along < least) least = along, to = k;
        }
        const Vec3 shift = rim[to] - rim[from];
        const Real amount = std::min(weight[from], -mean.dot(shift) / std::max(shift.squaredNorm(), Real(1e-300)));
        if (!(amount > 0)) break;
        weight[from] -= amount;
        weight[to] += amount;
        mean += amount * shift;
    }
    Real square = 0, total = 0;
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < rim.size(); ++k) {
        square += weight[k] * rim[k].squaredNorm();
        sum += weight[k] * rim[k];
        total += weight[k];
    }
    return std::sqrt(std::max(Real(0), square / total - (sum / total).squaredNorm()));
}

}  // namespace drape::test
