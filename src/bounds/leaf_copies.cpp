#include "drape/bounds/leaf_copies.h"

#include <algorithm>
#include <cmath>

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

/// All of some points, row by row.
Patch patch_at(const Points& x, int columns, int rows) {
    return {x.col(0).data(), x.col(1).data(), x.col(2).data(), columns, rows, columns};
}

Real displacement_of(const Patch& now, const Patch& before, Kernels kernels) {
    const Real square =
        kernels == Kernels::Plain ? largest_square(now, before) : kernels::largest_displacement_square(now, before);
    return std::sqrt(square) * rounded_up;
}

}  // namespace

Real largest_displacement(const Points& x, const Points& before, Kernels kernels) {
    const int n = static_cast<int>(x.rows());
    return displacement_of(patch_at(x, n, 1), patch_at(before, n, 1), kernels);
}

void LeafCopies::take(std::size_t leaf, const Patch& patch) {
    if (leaf >= copies_.size()) copies_.resize(leaf + 1);
    copies_[leaf].resize(patch.particles(), 3);
    Real* to = copies_[leaf].data();
    for (const Real* from : {patch.x, patch.y, patch.z}) {
        for (int j = 0; j < patch.rows; ++j) to = std::copy_n(from + j * patch.stride, patch.columns, to);
    }
}

Real LeafCopies::displacement(std::size_t leaf, const Patch& patch, Kernels kernels) const {
    return displacement_of(patch, patch_at(copies_[leaf], patch.columns, patch.rows), kernels);
}

}  // namespace drape
