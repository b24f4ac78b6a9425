#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "drape/contact/solid_shape.h"
#include "drape/model/ball.h"

namespace drape {

/// Friction and bounce of a surface.
struct Surface {
    Real friction = Real(0.3);  ///< Coulomb coefficient
    Real restitution = 0;       ///< of the normal speed
    Real rolling = 0;           ///< resistance to rolling: its torque on a ball is rolling * radius * load
    bool operator==(const Surface&) const = default;
};

/// The horizontal plane that is drawn, and on which things rest where it is solid.
struct Ground {
    Real height = -1;           ///< [m]
    bool solid = true;          ///< cloth and balls stay above it
    Real friction = Real(0.5);  ///< Coulomb coefficient of whatever lies on it
    Real restitution = 0;       ///< of the normal speed
    Real rolling = 0;           ///< as in `Surface`
    bool operator==(const Ground&) const = default;
};

/// A shape in its place. Nothing pushes it.
struct Solid {
    std::shared_ptr<const SolidShape> shape;
    Vec3 position = Vec3::Zero();  ///< of the shape's origin [m]
    Eigen::Quaternion<Real> orientation = Eigen::Quaternion<Real>::Identity();
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    Vec3 moved = Vec3::Zero();     ///< within the present substep [m]

    /// @param p in the world [m]
    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const {
        const SurfaceDistance own = shape->measure(in_own_frame(p));
        return {own.distance, orientation * own.normal};
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
};

/// What cloth and balls can touch: a ball, a solid or the ground, as it moves within the present substep. What is no
/// ball has the radius 0; its centre is the origin of the solid's shape, or any point of the ground's surface.
struct Body : Ball {
    const Solid* solid = nullptr;  ///< whose shape it has; null: it is a ball, or the ground
    Surface surface;
    bool is_motor = false;  ///< it pushes what can be moved, and is stopped by what cannot

    /// Whether a contact can move it.
    [[nodiscard]] bool gives_way() const { return inverse_mass > 0 || is_motor; }

    [[nodiscard]] bool is_ball() const { return radius > 0; }
    [[nodiscard]] bool is_ground() const { return solid == nullptr && radius == 0; }

    /// From a point to its surface, at the end of the substep.
    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const {
        if (solid != nullptr) return solid->measure(p);
        if (is_ground()) return {p.y() - centre.y(), Vec3(0, 1, 0)};
        const Vec3 offset = p - centre;
        const Real distance = offset.norm();
        return {distance - radius, distance > 0 ? Vec3(offset / distance) : Vec3(0, 1, 0)};
    }

    /// From a ball's centre to where it touches; zero for all else, which does not turn.
    /// @param outwards out of this body, length 1
    [[nodiscard]] Vec3 arm(const Vec3& outwards) const { return radius * outwards; }
};

/// Whether one is a motor and the other cannot be moved.
inline bool stops_motor(const Body& first, const Body& second) {
    return first.inverse_mass + second.inverse_mass == 0 && first.is_motor != second.is_motor;
}

inline Body body_of(const Ball& ball, const Surface& surface) { return {ball, nullptr, surface}; }

/// @param solid stays where it is as long as the body is used
inline Body body_of(const Solid& solid, const Surface& surface) {
    return {{.centre = solid.position, .radius = 0, .velocity = solid.velocity, .moved = solid.moved}, &solid, surface};
}

inline Body body_of(const Ground& ground) {
    return {{.centre = Vec3(0, ground.height, 0), .radius = 0},
            nullptr,
            {ground.friction, ground.restitution, ground.rolling}};
}

}  // namespace drape
