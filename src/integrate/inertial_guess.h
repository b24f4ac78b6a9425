#pragma once

#include "drape/model/force_sweep.h"

namespace drape {

/// Resistance of a particle to a change of velocity within a step h: its mass, and the drag at the step's end,
/// m + h b [kg]. With it, drag never limits the step.
inline Real inertia(const ClothModel& model, Real h) { return model.particle_mass + h * model.drag; }

/// Where the external forces alone would move the cloth; the positional methods correct it from there.
class InertialGuess {
public:
    InertialGuess(const Grid& grid, Kernels kernels) : forces_(grid, kernels) {}

    /// v += h f / (m + h b) with f of gravity, drag, wind and steady pushes at the start; x += h v. Pinned particles
    /// move as held.
    void advance(const ClothModel& model, ClothState& state, Real h);

private:
    ClothModel external_;  ///< the model without its springs
    ForceSweep forces_;
};

/// The velocity of free particles from their displacement, v = (x - start) / h; pinned ones keep theirs.
/// @param start n x 3 positions at the start of the step [m]
void set_velocity_from_displacement(const ClothModel& model, const Points& start, Real h, ClothState& state);

}  // namespace drape
