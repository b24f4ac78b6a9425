#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "drape/contact/solid_shape.h"

namespace drape {

/// A shape in its place. Nothing pushes it.
struct Solid {
    std::shared_ptr<const SolidShape> shape;
    Vec3 position = Vec3::Zero();  ///< of the shape's origin [m]
    Eigen::Quaternion<Real> orientation = Eigen::Quaternion<Real>::Identity();
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    Vec3 moved = Vec3::Zero();     ///< within the present substep [m]

    /// @param p in the world [m]
    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const { return in_world(shape->measure(in_own_frame(p))); }

    /// The same, faster, for a point that is known to be within `farthest` of the surface [m].
    [[nodiscard]] SurfaceDistance measure_near(const Vec3& p, Real farthest) const {
        return in_world(shape->measure_near(in_own_frame(p), farthest));
    }

    /// @param triangle in the world [m], see `SolidShape::clearance`
    [[nodiscard]] Real clearance(const std::array<Vec3, 3>& triangle, Real asked) const {
        return shape->clearance({in_own_frame(triangle[0]), in_own_frame(triangle[1]), in_own_frame(triangle[2])},
                                asked);
    }

    /// From a point to the surface, less than zero inside [m].
    [[nodiscard]] Real distance(const Vec3& p) const { return measure(p).distance; }

private:
    [[nodiscard]] Vec3 in_own_frame(const Vec3& p) const { return orientation.conjugate() * (p - position); }
    [[nodiscard]] SurfaceDistance in_world(const SurfaceDistance& own) const {
        return {own.distance, orientation * own.normal};
    }
};

}  // namespace drape
