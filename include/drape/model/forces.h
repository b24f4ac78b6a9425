#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "drape/model/cloth_model.h"

/// The forces on a cloth, written to be read: plain code, each beside its equation. `ForceSweep` computes the same ones
/// with wide vectors.
namespace drape {

/// The force of one spring on its end a; that on its end b is the opposite:
///
///     f = -(k (|d| - L0) + c n.w) n    with d = x_a - x_b, w = v_a - v_b, n = d/|d|
///
/// A spring of zero length has no direction, and gives no force.
/// @param d [m], w [m/s]
/// @return [N]
/// @cite witkin1997
inline Vec3 spring_force(const SpringLaw& law, Real rest_length, const Vec3& d, const Vec3& w) {
    const Real length = d.norm();
    if (length == 0) return Vec3::Zero();
    const Vec3 n = d / length;
    return -(law.stiffness * (length - rest_length) + law.damping * n.dot(w)) * n;
}

/// Drag coefficient C of a square plate across the flow.
/// @cite hoerner1965
constexpr Real plate_coefficient = Real(1.17);

/// The force of the moving air on one triangle, the pressure on a flat plate along its normal n:
///
///     f = 1/2 C rho |u.n| (u.n) A n    with u the velocity of the air less the mean of the corners'
///
/// In terms of the area vector S = A n, that is 1/2 C rho |u.S| (u.S) / |S|^2 S. A triangle without area feels nothing.
/// @param x [m], v [m/s] of the three corners
/// @return [N], a third of it for each corner
/// @cite hoerner1965
inline Vec3 wind_force(const Air& air, const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& v) {
    const Vec3 s = (x[1] - x[0]).cross(x[2] - x[0]) / 2;
    const Vec3 u = air.velocity - (v[0] + v[1] + v[2]) / 3;
    const Real flow = u.dot(s), square = s.squaredNorm();
    if (square == 0) return Vec3::Zero();
    return plate_coefficient * air.density / 2 * std::abs(flow) * flow / square * s;
}

/// How that force resists the corners' velocities: its derivative by the velocity of any corner, on any corner, is -g
/// g' with this g, where a third of f acts on each. With S as above, g g' is 1/9 C rho |u.S| S S' / |S|^2.
/// @param facing as if the air met the triangle along its normal, which is the most that it can resist
/// @return [sqrt(N s/m)]
inline Vec3 wind_resistance(const Air& air, const std::array<Vec3, 3>& x, const std::array<Vec3, 3>& v, bool facing) {
    const Vec3 s = (x[1] - x[0]).cross(x[2] - x[0]) / 2;
    const Vec3 u = air.velocity - (v[0] + v[1] + v[2]) / 3;
    const Real square = s.squaredNorm(), flow = facing ? u.norm() * std::sqrt(square) : std::abs(u.dot(s));
    if (square == 0) return Vec3::Zero();
    return std::sqrt(plate_coefficient * air.density * flow / square) / 3 * s;
}

/// The force on every particle: gravity, air drag, wind and springs.
/// @param x n x 3 [m]
/// @param v n x 3 [m/s]
/// @param f n x 3 [N], overwritten; forces on pinned particles are computed and are the caller's to ignore
/// @pre the three have the model's number of rows
/// @par Cost O(n), no allocation
void compute_forces(const ClothModel& model, const Points& x, const Points& v, Points& f);

/// The force on one particle, but for the wind's.
/// @return [N]
/// @par Cost its twelve springs
Vec3 force_on(const ClothModel& model, const Points& x, const Points& v, int particle);

/// Adds the force of the wind on every triangle to that on its corners.
/// @param f n x 3 [N]
void add_wind_forces(const ClothModel& model, const Points& x, const Points& v, Points& f);

}  // namespace drape
