#include "drape/bounds/bounding_sphere.h"

#include <algorithm>
#include <cmath>

#include "drape/base/vectorise.h"

namespace drape {
namespace kernels {

/// Partial results of wide patches are kept in this many lanes, whatever the width of the processor's vectors, so that
/// the bits are the same on all of them.
constexpr int lanes = 8;

/// Adds up lanes pairwise.
template <int count>
DRAPE_INLINE Real total(const Real* value) {
    if constexpr (count == 1)
        return value[0];
    else
        return total<(count + 1) / 2>(value) + total<count / 2>(value + (count + 1) / 2);
}

template <int count>
DRAPE_INLINE Real largest(const Real* value) {
    Real most = value[0];
    for (int lane = 1; lane < count; ++lane) most = most < value[lane] ? value[lane] : most;
    return most;
}

/// Mean over the patch; `width` is the number of columns if that is fixed, else 0. The three coordinates go together,
/// so that no addition waits for the one before.
template <int width>
DRAPE_INLINE void mean(const Patch& patch, Real centre[3]) {
    constexpr int count = width > 0 ? width : lanes;
    Real sum_x[count] = {}, sum_y[count] = {}, sum_z[count] = {};
    for (int j = 0; j < patch.rows; ++j) {
        const int start = j * patch.stride;
        const Real *x = patch.x + start, *y = patch.y + start, *z = patch.z + start;
        const int columns = width > 0 ? width : patch.columns;
        int i = 0;
        for (; i + count <= columns; i += count) {
            for (int lane = 0; lane < count; ++lane) sum_x[lane] += x[i + lane];
            for (int lane = 0; lane < count; ++lane) sum_y[lane] += y[i + lane];
            for (int lane = 0; lane < count; ++lane) sum_z[lane] += z[i + lane];
        }
        for (int lane = 0; i + lane < columns; ++lane) {
            sum_x[lane] += x[i + lane];
            sum_y[lane] += y[i + lane];
            sum_z[lane] += z[i + lane];
        }
    }
    const auto particles = static_cast<Real>(patch.columns * patch.rows);
    centre[0] = total<count>(sum_x) / particles;
    centre[1] = total<count>(sum_y) / particles;
    centre[2] = total<count>(sum_z) / particles;
}

/// The largest squared distance of the patch's particles from c.
template <int width>
DRAPE_INLINE Real farthest_square(const Patch& patch, const Real c[3]) {
    constexpr int count = width > 0 ? width : lanes;
    Real far[count] = {};
    for (int j = 0; j < patch.rows; ++j) {
        const int start = j * patch.stride;
        const Real *x = patch.x + start, *y = patch.y + start, *z = patch.z + start;
        const auto raise = [&](int i, int lane) {
            const Real dx = x[i] - c[0], dy = y[i] - c[1], dz = z[i] - c[2];
            const Real square = dx * dx + dy * dy + dz * dz;
            far[lane] = far[lane] < square ? square : far[lane];
        };
        const int columns = width > 0 ? width : patch.columns;
        int i = 0;
        for (; i + count <= columns; i += count) {
            for (int lane = 0; lane < count; ++lane) raise(i + lane, lane);
        }
        for (int lane = 0; i + lane < columns; ++lane) raise(i + lane, lane);
    }
    return largest<count>(far);
}

template <int width>
DRAPE_INLINE Real fit_width(const Patch& patch, Real centre[3]) {
    mean<width>(patch, centre);
    return farthest_square<width>(patch, centre);
}

/// Patches of at most nine columns, the leaves and their parents, keep one lane a column: their rows have no remainder,
/// and the compiler knows their length.
/// @return the squared radius
DRAPE_VECTORISE Real fit_centroid_sphere(const Patch& patch, Real centre[3]) {
    switch (patch.columns) {
        case 2:
            return fit_width<2>(patch, centre);
        case 3:
            return fit_width<3>(patch, centre);
        case 4:
            return fit_width<4>(patch, centre);
        case 5:
            return fit_width<5>(patch, centre);
        case 6:
            return fit_width<6>(patch, centre);
        case 7:
            return fit_width<7>(patch, centre);
        case 8:
            return fit_width<8>(patch, centre);
        case 9:
            return fit_width<9>(patch, centre);
        default:
            return fit_width<0>(patch, centre);
    }
}

}  // namespace kernels

BoundingSphere BoundingSphere::fit(const Patch& patch, Real thickness) {
    BoundingSphere sphere;
    const Real square = kernels::fit_centroid_sphere(patch, sphere.centre.data());
    sphere.radius = std::sqrt(square) * (1 + 8 * std::numeric_limits<Real>::epsilon()) + thickness;
    return sphere;
}

}  // namespace drape
