#include "drape/bounds/leaf_copies.h"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

/// All of some points, row by row.
Patch patch_at(const Points& x, int columns, int rows) {
    return {x.col(0).data(), x.col(1).data(), x.col(2).data(), columns, rows, columns};
}

/// One coordinate of the particles of a patch.
auto coordinates(const Patch& patch, const Real* from) {
    using Coordinates = Eigen::Array<Real, Eigen::Dynamic, Eigen::Dynamic>;
    return Eigen::Map<const Coordinates, 0, Eigen::OuterStride<>>(from, patch.columns, patch.rows,
                                                                  Eigen::OuterStride<>(patch.stride));
}

Real largest_displacement(const Patch& now, const Patch& before) {
    const auto square = [&](const Real* Patch::*of) {
        return (coordinates(now, now.*of) - coordinates(before, before.*of)).square();
    };
    return std::sqrt(((square(&Patch::x) + square(&Patch::y)) + square(&Patch::z)).maxCoeff()) * rounded_up;
}

}  // namespace

Real largest_displacement(const Points& x, const Points& before) {
    const int n = static_cast<int>(x.rows());
    return largest_displacement(patch_at(x, n, 1), patch_at(before, n, 1));
}

void LeafCopies::take(std::size_t leaf, const Patch& patch) {
    if (leaf >= copies_.size()) copies_.resize(leaf + 1);
    copies_[leaf].resize(patch.particles(), 3);
    Real* to = copies_[leaf].data();
    for (const Real* from : {patch.x, patch.y, patch.z}) {
        for (int j = 0; j < patch.rows; ++j) to = std::copy_n(from + j * patch.stride, patch.columns, to);
    }
}

Real LeafCopies::displacement(std::size_t leaf, const Patch& patch) const {
    return largest_displacement(patch, patch_at(copies_[leaf], patch.columns, patch.rows));
}

}  // namespace drape
