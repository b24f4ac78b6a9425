#include "drape/bounds/leaf_copies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/patch_kernels.h"

namespace drape {
namespace {

Real largest_square(const Patch& now, const Patch& before) {
    Real square = 0;
    for (int j = 0; j < now.rows; ++j) {
        for (int i = 0; i < now.columns; ++i) {
            square = std::max(square, (now.at(i, j) - before.at(i, j)).squaredNorm());
        }
    }
    return square;
}

Real displacement_of(const Patch& now, const Patch& before, Kernels kernels) {
    const Real square =
        kernels == Kernels::Plain ? largest_square(now, before) : kernels::largest_displacement_square(now, before);
    return std::sqrt(square) * (1 + 8 * std::numeric_limits<Real>::epsilon());
}

}  // namespace

Real largest_displacement(const Points& x, const Points& before, Kernels kernels) {
    const auto row = [](const Points& points) {
        const int n = static_cast<int>(points.rows());
        return Patch{points.col(0).data(), points.col(1).data(), points.col(2).data(), n, 1, n};
    };
    return displacement_of(row(x), row(before), kernels);
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

Real LeafCopies::displacement(std::size_t leaf, const Patch& patch, Kernels kernels) const {
    const Real* const x = coordinates_.data() + starts_[leaf];
    const int n = patch.particles();
    return displacement_of(patch, {x, x + n, x + 2 * n, patch.columns, patch.rows, patch.columns}, kernels);
}

}  // namespace drape
