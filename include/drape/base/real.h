#pragma once

#include <Eigen/Core>

namespace drape {

/// The scalar of every simulated quantity; `float` in the single-precision build of the library.
#ifdef DRAPE_SINGLE
using Real = float;
#else
using Real = double;
#endif

/// A point, direction or velocity in space.
using Vec3 = Eigen::Matrix<Real, 3, 1>;

/// Whether a direction or a turn has length 1, but for rounding.
template <class Vector>
[[nodiscard]] bool has_length_one(const Vector& vector) {
    constexpr auto rounding = Real(1e-5);
    return vector.norm() >= 1 - rounding && vector.norm() <= 1 + rounding;
}

/// One row a particle: n x 3, column-major, so that each coordinate is one contiguous array.
using Points = Eigen::Matrix<Real, Eigen::Dynamic, 3>;

}  // namespace drape
