#pragma once

#include "drape/model/force_sweep.h"
#include "drape/model/forces.h"

namespace drape {

/// One number a particle.
using Numbers = Eigen::Array<Real, Eigen::Dynamic, 1>;

/// Resistance of each particle to a change of its velocity within a step h [kg]: its mass, and the drag and the force
/// of the wind at the step's end, m + h (b + d). With it, neither limits the step. The wind resists along the
/// triangles' normals, and with the neighbours' velocities; d, the sum of 3 |g|^2 over the triangles at the particle
/// (see `wind_resistance`), is as much in all directions, and by its own velocity alone.
/// @param inertia n x 1, overwritten
inline void find_inertia(const ClothModel& model, const ClothState& state, Real h, Numbers& inertia) {
    inertia.setConstant(model.grid.particles(), model.particle_mass + h * model.drag);
    if (model.air.density == 0) return;
    for (int triangle = 0; triangle < model.grid.triangles(); ++triangle) {
        const auto [a, b, c] = model.grid.triangle_corners(triangle);
        const Vec3 g = wind_resistance(model.air, {state.x.row(a), state.x.row(b), state.x.row(c)},
                                       {state.v.row(a), state.v.row(b), state.v.row(c)}, false);
        for (const int corner : {a, b, c}) inertia[corner] += 3 * h * g.squaredNorm();
    }
}

/// Where the external forces alone would move the cloth; the positional methods correct it from there.
class InertialGuess {
public:
    InertialGuess(const Grid& grid, Kernels kernels) : forces_(grid, kernels) {}

    /// v += h f / inertia with f of gravity, drag and wind at the start; x += h v. Pinned particles move
    /// as held.
    /// @param inertia as found at this state
    void advance(const ClothModel& model, const Numbers& inertia, ClothState& state, Real h) {
        const Real calm = model.particle_mass + h * model.drag, h_less_drag = h * model.particle_mass / calm;
        external_ = model;
        external_.structural = external_.shear = external_.bend = {};
        external_.inverse_mass *= calm / inertia;
        forces_(external_, state.x, state.v, [&](const ForceRun& run) {
            run.of(state.v) += h_less_drag * run.accelerations();
            run.of(state.x) += h * run.of(state.v);
        });
    }

private:
    ClothModel external_;  ///< the model without its springs
    ForceSweep forces_;
};

/// The velocity of free particles from their displacement, v = (x - start) / h; pinned ones keep theirs.
/// @param start n x 3 positions at the start of the step [m]
inline void set_velocity_from_displacement(const ClothModel& model, const Points& start, Real h, ClothState& state) {
    for (Eigen::Index p = 0; p < start.rows(); ++p) {
        if (model.inverse_mass[p] > 0) state.v.row(p) = (state.x.row(p) - start.row(p)) / h;
    }
}

}  // namespace drape
