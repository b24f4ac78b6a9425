#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "drape/bounds/node_view.h"

namespace drape::test {

using Exact = Eigen::Matrix<long double, 3, 1>;

/// How far p stands out of what lies between two bounds along a direction of some length.
inline long double beyond(long double place, long double low, long double high, long double length = 1) {
    return std::max(low - place, place - high) / length;
}

/// How far a point stands out of a volume, negative within: from the shape's definition, in long double [m].
inline long double stands_out(const BoundingSphere& sphere, const Vec3& p) {
    return (p.cast<long double>() - sphere.centre.cast<long double>()).norm() - sphere.radius;
}
inline long double stands_out(const Aabb& box, const Vec3& p) {
    long double most = beyond(p[0], box.low[0], box.high[0]);
    for (int k = 1; k < 3; ++k) most = std::max(most, beyond(p[k], box.low[k], box.high[k]));
    return most;
}
template <int K>
long double stands_out(const KDop<K>& dop, const Vec3& p) {
    long double most = stands_out(dop.box, p);
    for (std::size_t k = 0; k < KDop<K>::cuts; ++k) {
        const auto& axis = dop_axes[static_cast<std::size_t>(dop_numbers<K>[k + 3])];
        const Exact direction(axis[0], axis[1], axis[2]);
        most = std::max(most, beyond(direction.dot(p.cast<long double>()), dop.low[k], dop.high[k], direction.norm()));
    }
    return most;
}
inline long double stands_out(const Obb& box, const Vec3& p) {
    const Exact place =
        box.axes.cast<long double>().transpose() * (p.cast<long double>() - box.origin.cast<long double>());
    long double most = beyond(place[0], box.low[0], box.high[0]);
    for (int k = 1; k < 3; ++k) most = std::max(most, beyond(place[k], box.low[k], box.high[k]));
    return most;
}

template <class Volumes>
struct TypesOf;
template <class... Volumes>
struct TypesOf<std::variant<Volumes...>> {
    using Types = ::testing::Types<Volumes...>;
};
using AllVolumes = TypesOf<AnyVolume>::Types;

/// One of each sort, for what does not depend on the number of slabs.
using UnlikeVolumes = ::testing::Types<BoundingSphere, Aabb, KDop<18>, Obb>;

/// Names typed tests by their volume.
struct VolumeNames {
    template <class V>
    static std::string GetName(int) {
        return name_of(static_cast<VolumeKind>(AnyVolume(V()).index()));
    }
};

/// All particles of a cloth as one patch.
inline Patch whole(const Points& x, const Grid& grid) {
    return {x.col(0).data(), x.col(1).data(), x.col(2).data(), grid.nx, grid.ny, grid.nx};
}

/// The farthest that a particle of a patch stands out of a volume; NaN if one does.
template <class Volume>
long double farthest_out(const Volume& volume, const Patch& patch) {
    long double most = -std::numeric_limits<long double>::infinity();
    for (int j = 0; j < patch.rows; ++j) {
        for (int i = 0; i < patch.columns; ++i) {
            const long double out = stands_out(volume, patch.at(i, j));
            if (std::isnan(out)) return out;
            most = std::max(most, out);
        }
    }
    return most;
}

/// How many nodes of a tree, grown by the slack, do not contain every particle below them, to 1e-12 of the cloth's
/// coordinates.
template <class Volume>
int breaches(const Grid& grid, const std::vector<QuadtreeNode>& nodes, std::span<const Volume> volumes, Real slack,
             const Points& x) {
    const long double allowed = slack + 1e-12L * x.cwiseAbs().maxCoeff();
    int count = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (!(farthest_out(volumes[n], patch_of(grid, nodes[n], x)) <= allowed)) ++count;
    }
    return count;
}

}  // namespace drape::test
