#pragma once

#include <Eigen/Geometry>

#include "drape/base/real.h"

namespace drape {

/// A rigid solid sphere.
struct Ball {
    Vec3 centre = Vec3::Zero();    ///< [m]
    Real radius = Real(0.3);       ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    Real inverse_mass = 0;         ///< 0: no contact moves it [1/kg]
    Vec3 spin = Vec3::Zero();      ///< angular velocity [rad/s]
    Eigen::Quaternion<Real> orientation = Eigen::Quaternion<Real>::Identity();
    Vec3 moved = Vec3::Zero();   ///< by its centre within the present substep [m]
    Vec3 turned = Vec3::Zero();  ///< within the present substep, axis times angle [rad]

    /// 1 / (2/5 m r^2) [1/(kg m^2)]
    [[nodiscard]] Real inverse_inertia() const {
        return inverse_mass == 0 ? 0 : Real(2.5) * inverse_mass / (radius * radius);
    }
};

}  // namespace drape
