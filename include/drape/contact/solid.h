#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "drape/bounds/distance_field.h"
#include "drape/contact/solid_shape.h"

namespace drape {

/// A shape in its place. Nothing pushes it.
struct Solid final : DistanceField {
    std::shared_ptr<const SolidShape> shape;
    Vec3 position = Vec3::Zero();  ///< of the shape's origin [m]
    Eigen::Quaternion<Real> orientation = Eigen::Quaternion<Real>::Identity();
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    Vec3 moved = Vec3::Zero();     ///< within the present substep [m]

    /// @param p in the world [m]
    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const {
        const SurfaceDistance own = shape->measure(orientation.conjugate() * (p - position));
        return {own.distance, orientation * own.normal};
    }

    [[nodiscard]] Real distance(const Vec3& p) const override { return measure(p).distance; }
};

}  // namespace drape
