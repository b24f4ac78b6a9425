#pragma once

#include <concepts>
#include <string_view>

#include "drape/base/real.h"
#include "drape/model/ball.h"

namespace drape {

/// The particles of a rectangle of cells, as seen by a volume's fit: `rows` rows of `columns` particles, the first at
/// (x[0], y[0], z[0]), the start of each next row `stride` further on.
struct Patch {
    const Real* x;
    const Real* y;
    const Real* z;
    int columns;
    int rows;
    int stride;
};

/// Where a volume stands in space, for drawing: the image of the unit shape under p -> axes p + centre.
struct Placement {
    Vec3 centre = Vec3::Zero();
    Eigen::Matrix<Real, 3, 3> axes = Eigen::Matrix<Real, 3, 3>::Zero();
};

/// What a hierarchy needs of a volume. `fit` bounds every particle of the patch, grown by `thickness`, rounding
/// included; `overlaps` is true whenever the ball has a point in common with the volume.
template <class V>
concept BoundingVolume = requires(const V volume, const Patch& patch, const Ball& ball, Real thickness) {
    { V::fit(patch, thickness) } -> std::same_as<V>;
    { volume.overlaps(ball) } -> std::same_as<bool>;
    { volume.placement() } -> std::same_as<Placement>;
    { V::name } -> std::convertible_to<std::string_view>;
};

}  // namespace drape
