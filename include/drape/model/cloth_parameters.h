#pragma once

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

    /// From particle (0,0) to the last one, in the cloth's plane [m].
    [[nodiscard]] Vec3 diagonal() const {
        return plane == Plane::XZ ? Vec3(width, 0, height) : Vec3(width, -height, 0);
    }

    /// Where particle (0,0) and the centre start [m].
    [[nodiscard]] Vec3 origin() const { return centred ? Vec3(place - diagonal() / 2) : place; }
    [[nodiscard]] Vec3 centre() const { return centred ? place : Vec3(place + diagonal() / 2); }
};

}  // namespace drape
