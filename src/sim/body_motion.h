#pragma once

#include <optional>
#include <vector>

#include "drape/contact/body.h"
#include "drape/model/ball.h"
#include "drape/scene/settings.h"

namespace drape {

/// The ball as it is at a time [s], at the start or on its path.
/// @param start how it moves and, but on a path, where it is instead; null: as the settings have it
Ball make_ball(const BallSettings& settings, double time, const Ball* start = nullptr);

/// 1/mass of a free ball, 0 of any other: no contact moves it [1/kg].
Real inverse_mass_of(const BallSettings& settings);

/// Moves a ball over one substep, from `time` to `time + h`, by its kind of motion; its velocity is that of the
/// substep. A free ball falls as a particle does, so that what rests on the other has the same balance of pushes.
/// @param by_hand velocity that the hand asks for, of a ball that it holds [m/s]; one of the keys or a free one follows
/// it
/// @param steer direction that the keys ask for, of length 0 or 1
/// @param gravity of a free ball [m/s^2]
/// @param displacement_factor of the integrator, see the function of this name
void move_ball(const BallSettings& settings, const std::optional<Vec3>& by_hand, const Vec3& steer, const Vec3& gravity,
               Real displacement_factor, Real time, Real h, Ball& ball);

/// Rolling resistance: slows the spin of a ball by the torque coefficient * radius * load, and no further than to a
/// stop. Friction then slows the ball: a rolling one by 5/7 coefficient * g [m/s^2].
/// @param load impulse that what it lies on has given it within the substep [N s]
void resist_rolling(Real coefficient, Real load, Ball& ball);

/// Turns a ball by what it has turned within the substep, contacts included: q += w h / 2 q, of length 1 again.
void turn_ball(Ball& ball);

/// The solids that the settings describe, with their meshes read from files.
/// @throws InputError that names file and line
std::vector<Solid> make_solids(const std::vector<SolidSettings>& settings);

/// Puts solids where they are at a time [s], at rest.
void put_solids(const std::vector<SolidSettings>& settings, double time, std::vector<Solid>& solids);

/// Moves a solid over one substep, from `time` to `time + h` [s].
void move_solid(const SolidSettings& settings, Real time, Real h, Solid& solid);

/// A turn by so many whole turns, with the same bits everywhere.
/// @param axis of length 1
Eigen::Quaternion<Real> turn_about(const Vec3& axis, double turns);

/// The air at a time [s]: the mean wind with two gusts of incommensurate frequency on it. It depends on time alone.
Air air_at(const WindSettings& wind, double time);

/// The fastest that it can get.
Air strongest_air(const WindSettings& wind);

/// Where a path leads at a time: a smooth curve through its points. It rests at its last point, or repeats if that is
/// its first one again.
/// @pre at least two points, times ascending
Vec3 point_on_path(const std::vector<PathPoint>& path, Real time);

}  // namespace drape
