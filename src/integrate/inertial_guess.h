#pragma once

#include "drape/model/force_sweep.h"

namespace drape {

/// One number a particle.
using Numbers = Eigen::Array<Real, Eigen::Dynamic, 1>;

/// Resistance of each particle to a change of its velocity within a step h [kg]: its mass, and the drag and the force
/// of the wind at the step's end, m + h (b + d). With it, neither limits the step. The wind resists along the
/// triangles' normals, and with the neighbours' velocities; d, the sum of 3 |g|^2 over the triangles at the particle
/// (see `wind_resistance`), is as much in all directions, and by its own velocity alone.
/// @param inertia n x 1, overwritten
void find_inertia(const ClothModel& model, const ClothState& state, Real h, Numbers& inertia);

/// Where the external forces alone would move the cloth; the positional methods correct it from there.
class InertialGuess {
public:
    InertialGuess(const Grid& grid, Kernels kernels) : forces_(grid, kernels) {}

    /// v += h f / inertia with f of gravity, drag and wind at the start; x += h v. Pinned particles move
    /// as held.
    /// @param inertia as found at this state
    void advance(const ClothModel& model, const Numbers& inertia, ClothState& state, Real h);

private:
    ClothModel external_;  ///< the model without its springs
    ForceSweep forces_;
};

/// The velocity of free particles from their displacement, v = (x - start) / h; pinned ones keep theirs.
/// @param start n x 3 positions at the start of the step [m]
void set_velocity_from_displacement(const ClothModel& model, const Points& start, Real h, ClothState& state);

}  // namespace drape
