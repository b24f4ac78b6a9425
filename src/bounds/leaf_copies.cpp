#include "drape/bounds/leaf_copies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "patch_kernels.h"

namespace drape {
namespace {

Real displacement_of(const Patch& now, const Patch& before) {
    return std::sqrt(kernels::largest_displacement_square(now, before)) *
           (1 + 8 * std::numeric_limits<Real>::epsilon());
}

}  // namespace

Real largest_displacement(const Points& x, const Points& before) {
    const auto row = [](const Points& points) {
        const int n = static_cast<int>(points.rows());
        return Patch{points.col(0).data(), points.col(1).data(), points.col(2).data(), n, 1, n};
    };
    return displacement_of(row(x), row(before));
}

void LeafCopies::take_all(const Grid& grid, std::span<const QuadtreeNode> nodes, const Points& x) {
    starts_.assign(nodes.size(), 0);
    std::size_t size = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        starts_[n] = size;
        if (nodes[n].children == 0) size += 3 * static_cast<std::size_t>(patch_of(grid, nodes[n], x).particles());
    }
    coordinates_.resize(size);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].children == 0) take(n, patch_of(grid, nodes[n], x));
    }
}

void LeafCopies::take(std::size_t leaf, const Patch& patch) {
    Real* to = coordinates_.data() + starts_[leaf];
    for (const Real* from : {patch.x, patch.y, patch.z}) {
        for (int j = 0; j < patch.rows; ++j) to = std::copy_n(from + j * patch.stride, patch.columns, to);
    }
}

Real LeafCopies::displacement(std::size_t leaf, const Patch& patch) const {
    const Real* const x = coordinates_.data() + starts_[leaf];
    const int n = patch.particles();
    return displacement_of(patch, {x, x + n, x + 2 * n, patch.columns, patch.rows, patch.columns});
}

}  // namespace drape
