#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "drape/base/enum_names.h"
#include "drape/base/real.h"
#include "drape/model/grid.h"

namespace drape {

/// A kind of spring: f_a = -(k (|d| - L0) + c n.(v_a - v_b)) n.
struct SpringLaw {
    Real stiffness = 0;  ///< k [N/m]
    Real damping = 0;    ///< c [N s/m]
    bool operator==(const SpringLaw&) const = default;
};

/// The plane in which a cloth starts: `XZ` is horizontal, `XY` is vertical.
enum class Plane { XZ, XY };

/// Which particles never move: one of the names none, two, four, row, border, or a list of particle numbers.
struct Pins {
    enum class Kind { None, Two, Four, Row, Border, List };
    Kind kind = Kind::None;
    std::vector<int> list;  ///< particle numbers, for `Kind::List` only
    bool operator==(const Pins&) const = default;
};

/// What describes a cloth, before anything is computed from it.
struct ClothParameters {
    Grid particles{30, 30};                  ///< columns, rows
    Real width = 1, height = 1;              ///< size along columns and rows [m]
    Real mass = Real(0.2);                   ///< whole cloth, pinned particles counted [kg]
    Plane plane = Plane::XZ;                 ///< where it starts
    Vec3 place = Vec3::Zero();               ///< where particle (0,0), or the centre, starts [m]
    bool centred = false;                    ///< `place` is the centre
    Pins pinned;                             ///< which particles never move
    SpringLaw structural{1000, Real(0.02)};  ///< to the 4 neighbours
    SpringLaw shear{500, Real(0.02)};        ///< to the 4 diagonals
    SpringLaw bend{100, Real(0.02)};         ///< to the 4 at distance two along rows and columns
    Real drag = Real(1e-4);                  ///< b of the air drag -b v, per particle [N s/m]
    Real stretch_limit = 0;                  ///< largest stretch of a structural spring, of its rest length; 0: none
    bool operator==(const ClothParameters&) const = default;

    /// Rest length along columns and rows [m].
    [[nodiscard]] Real hx() const { return width / static_cast<Real>(particles.nx - 1); }
    [[nodiscard]] Real hy() const { return height / static_cast<Real>(particles.ny - 1); }

    /// From particle (0,0) to the last one, in the cloth's plane [m].
    [[nodiscard]] Vec3 diagonal() const {
        return plane == Plane::XZ ? Vec3(width, 0, height) : Vec3(width, -height, 0);
    }

    /// Where particle (0,0) and the centre start [m].
    [[nodiscard]] Vec3 origin() const { return centred ? Vec3(place - diagonal() / 2) : place; }
    [[nodiscard]] Vec3 centre() const { return centred ? place : Vec3(place + diagonal() / 2); }
};

/// The whole state of a cloth. (BDF2 alone keeps one more, that of the step before, and restarts without it.)
struct ClothState {
    Points x;  ///< n x 3 positions [m]
    Points v;  ///< n x 3 velocities [m/s]
};

/// That of the earth [m/s^2].
inline Vec3 standard_gravity() { return {0, Real(-9.81), 0}; }

/// The air that the cloth moves in. It is constant over one step.
struct Air {
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    Real density = 0;              ///< [kg/m^3]; 0 turns the force by triangle off
};

/// What the forces on a cloth depend on, besides its state: grid, masses, springs, pins, and air.
/// Invariant: `inverse_mass` is 0 for a pinned particle and 1/particle_mass for every other.
struct ClothModel {
    Grid grid;
    Real hx = 0, hy = 0;                                 ///< rest length along columns and rows [m]
    Real particle_mass = 0;                              ///< [kg]
    Eigen::Array<Real, Eigen::Dynamic, 1> inverse_mass;  ///< n x 1 [1/kg]
    SpringLaw structural, shear, bend;
    Real drag = 0;                      ///< [N s/m]
    Real stretch_limit = 0;             ///< largest stretch of a structural spring, of its rest length; 0: none
    Vec3 gravity = standard_gravity();  ///< [m/s^2]
    Air air;
    std::uint64_t revision = 0;  ///< changes with every change of masses, springs or pins: the key of cached factors

    [[nodiscard]] bool pinned(int particle) const { return inverse_mass[particle] == 0; }

    /// At rest, along columns and rows [m].
    [[nodiscard]] Real width() const { return hx * static_cast<Real>(grid.nx - 1); }
    [[nodiscard]] Real height() const { return hy * static_cast<Real>(grid.ny - 1); }

    /// Holds a particle (it keeps whatever velocity it is given) or lets it go.
    void hold(int particle, bool held);
};

/// The earth's gravity, or that of the cloth where it is stronger: what forces and speeds are measured by, and so never
/// zero [m/s^2].
inline Real gravity_scale(const ClothModel& model) { return std::max(model.gravity.norm(), standard_gravity().norm()); }

/// Whether pins that have a name hold a particle of a grid.
[[nodiscard]] bool is_pinned(const Pins& pins, const Grid& grid, int particle);

/// @pre every length, mass and stiffness lies in its setting's range, and a pin list names particles of the grid.
ClothModel make_cloth_model(const ClothParameters& parameters);

/// The flat cloth at rest in its plane: x = origin + (i hx, 0, j hy) or origin + (i hx, -j hy, 0).
ClothState make_rest_state(const ClothParameters& parameters);

/// The points of a cloth at which another grid's particles lie, bilinearly between the particles that there are.
/// @param x of `from`, n x 3 [m]
/// @return of `to`, n x 3 [m]
Points resampled(const Points& x, const Grid& from, const Grid& to);

}  // namespace drape
