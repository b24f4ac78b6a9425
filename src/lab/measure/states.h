#pragma once

#include <cmath>
#include <random>

#include "drape/base/exact_math.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// A sheet of 1 m on which methods are compared. The drag on all of it takes a tenth of its speed in 0.04 s.
/// @param side particles along each
/// @param stiffness, damping of the structural springs
inline ClothParameters sheet_of(int side, Real stiffness, Real damping) {
    constexpr Real whole_drag = Real(0.5);  // N s/m
    ClothParameters cloth;
    cloth.particles = {side, side};
    cloth.structural = {stiffness, damping};
    cloth.shear = {stiffness / 2, damping};
    cloth.bend = {stiffness / 10, damping};
    cloth.drag = whole_drag / static_cast<Real>(cloth.particles.particles());
    return cloth;
}

/// An error at the start of a motion, as root mean square over the free particles [m]: small against any motion, large
/// against rounding.
constexpr Real small_error = sizeof(Real) == sizeof(double) ? Real(1e-9) : Real(1e-4);

/// An error that grows more than this on the way to a horizon makes positions there a matter of luck.
constexpr double most_growth = 50;

/// A state with that error in every free coordinate, the same each time: symmetry would hide what grows.
inline ClothState disturbed(const ClothModel& model, ClothState state) {
    std::mt19937 random(1);
    Points error = Points::Zero(state.x.rows(), 3);
    int free = 0;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) continue;
        ++free;
        for (int axis = 0; axis < 3; ++axis) error(p, axis) = uniform<Real>(random);
    }
    state.x += error * (small_error * std::sqrt(static_cast<Real>(free)) / error.norm());
    return state;
}

/// Root mean square distance of the particles, of the cloth's side.
inline double position_error(const Points& x, const Points& exact, Real side) {
    const double squares = static_cast<double>((x - exact).squaredNorm());
    return std::sqrt(squares / static_cast<double>(x.rows())) / static_cast<double>(side);
}

}  // namespace drape
