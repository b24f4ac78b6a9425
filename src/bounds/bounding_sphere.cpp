#include "drape/bounds/bounding_sphere.h"

#include <algorithm>
#include <cmath>

#include "drape/base/vectorise.h"

namespace drape {
namespace kernels {

/// Partial results are kept in this many lanes, whatever the width of the processor's vectors, so that the bits are the
/// same on all of them.
constexpr int lanes = 8;

struct Lanes {
    Real value[lanes] = {};
};

/// Adds a row of numbers, entry i to lane i mod 8.
DRAPE_INLINE void add_row(const Real* row, int count, Lanes& sum) {
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
        for (int lane = 0; lane < lanes; ++lane) sum.value[lane] += row[i + lane];
    }
    for (int lane = 0; i + lane < count; ++lane) sum.value[lane] += row[i + lane];
}

DRAPE_INLINE Real total(const Lanes& sum) {
    const Real* s = sum.value;
    return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

DRAPE_INLINE Real mean(const Patch& patch, const Real* coordinate) {
    Lanes sum;
    for (int j = 0; j < patch.rows; ++j) add_row(coordinate + j * patch.stride, patch.columns, sum);
    return total(sum) / static_cast<Real>(patch.columns * patch.rows);
}

/// Raises each lane to the squared distance of a row's particles from c.
DRAPE_INLINE void raise_row(const Real* x, const Real* y, const Real* z, int count, const Real c[3], Lanes& farthest) {
    const auto raise = [&](int i, int lane) {
        const Real dx = x[i] - c[0], dy = y[i] - c[1], dz = z[i] - c[2];
        const Real square = dx * dx + dy * dy + dz * dz;
        farthest.value[lane] = farthest.value[lane] < square ? square : farthest.value[lane];
    };
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
        for (int lane = 0; lane < lanes; ++lane) raise(i + lane, lane);
    }
    for (int lane = 0; i + lane < count; ++lane) raise(i + lane, lane);
}

DRAPE_VECTORISE void fit_centroid_sphere(const Patch& patch, Real centre[3], Real& square_radius) {
    centre[0] = mean(patch, patch.x);
    centre[1] = mean(patch, patch.y);
    centre[2] = mean(patch, patch.z);
    Lanes farthest;
    for (int j = 0; j < patch.rows; ++j) {
        const int start = j * patch.stride;
        raise_row(patch.x + start, patch.y + start, patch.z + start, patch.columns, centre, farthest);
    }
    square_radius = *std::max_element(farthest.value, farthest.value + lanes);
}

}  // namespace kernels

BoundingSphere BoundingSphere::fit(const Patch& patch, Real thickness) {
    BoundingSphere sphere;
    Real square = 0;
    kernels::fit_centroid_sphere(patch, sphere.centre.data(), square);
    sphere.radius = std::sqrt(square) * (1 + 8 * std::numeric_limits<Real>::epsilon()) + thickness;
    return sphere;
}

}  // namespace drape
