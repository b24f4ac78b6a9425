#include "drape/bounds/displacement.h"

#include <algorithm>
#include <cmath>

namespace drape {

Real largest_displacement(const Points& x, const Points& before) {
    const int n = static_cast<int>(x.rows());
    return largest_displacement(Patch{x.col(0).data(), x.col(1).data(), x.col(2).data(), n, 1, n}, before);
}

Real largest_displacement(const Patch& patch, const Points& before) {
    using Coordinates = Eigen::Array<Real, Eigen::Dynamic, Eigen::Dynamic>;
    const auto coordinates = [&](const Real* from, int stride) {
        return Eigen::Map<const Coordinates, 0, Eigen::OuterStride<>>(from, patch.columns, patch.rows,
                                                                      Eigen::OuterStride<>(stride));
    };
    const auto square = [&](const Real* now, int axis) {
        return (coordinates(now, patch.stride) - coordinates(before.col(axis).data(), patch.columns)).square();
    };
    return std::sqrt(((square(patch.x, 0) + square(patch.y, 1)) + square(patch.z, 2)).maxCoeff()) * rounded_up;
}

void copy_points(const Patch& patch, Points& to) {
    to.resize(patch.particles(), 3);
    Real* next = to.data();
    for (const Real* from : {patch.x, patch.y, patch.z}) {
        for (int j = 0; j < patch.rows; ++j) next = std::copy_n(from + j * patch.stride, patch.columns, next);
    }
}

}  // namespace drape
