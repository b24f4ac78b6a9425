#pragma once

#include "drape/contact/solid.h"
#include "drape/model/ball.h"
#include "drape/model/ground.h"

namespace drape {

/// Friction and bounce of a surface.
struct Surface {
    Real friction = Real(0.3);  ///< Coulomb coefficient
    Real restitution = 0;       ///< of the normal speed
    Real rolling = 0;           ///< resistance to rolling: its torque on a ball is rolling * radius * load
};

/// What cloth and balls can touch: a ball, a solid or the ground, as it moves within the present substep.
struct Body {
    const Solid* solid = nullptr;  ///< whose shape it has; null: it is a ball, or the ground
    Real radius = 0;               ///< of a ball; of all else 0 [m]
    Vec3 centre = Vec3::Zero();    ///< of a ball, origin of a solid's shape, any point of the ground's surface [m]
    Vec3 moved = Vec3::Zero();     ///< within the substep [m]
    Vec3 turned = Vec3::Zero();    ///< within the substep, axis times angle [rad]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    Vec3 spin = Vec3::Zero();      ///< [rad/s]
    Real inverse_mass = 0;         ///< 0: kinematic, no contact moves it [1/kg]
    Real inverse_inertia = 0;      ///< [1/(kg m^2)]
    Surface surface;

    [[nodiscard]] bool is_ball() const { return radius > 0; }
    [[nodiscard]] bool is_ground() const { return solid == nullptr && radius == 0; }

    /// From a point to its surface, at the end of the substep.
    [[nodiscard]] SurfaceDistance measure(const Vec3& p) const;

    /// From a ball's centre to where it touches; zero for all else, which does not turn.
    /// @param outwards out of this body, length 1
    [[nodiscard]] Vec3 arm(const Vec3& outwards) const { return radius * outwards; }
};

/// @param ball, solid stays where it is as long as the body is used
Body body_of(const Ball& ball, const Surface& surface);
Body body_of(const Solid& solid, const Surface& surface);
Body body_of(const Ground& ground);

/// Gives a ball the motion that contacts have left its body.
void store(const Body& body, Ball& ball);

}  // namespace drape
