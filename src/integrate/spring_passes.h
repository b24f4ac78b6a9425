#pragma once

#include "drape/base/assert.h"
#include "drape/base/kernels.h"
#include "drape/model/force_sweep.h"
#include "drape/model/forces.h"
#include "drape/model/stencils.h"
#include "kernels/spring_pass_kernels.h"

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

    /// v += h f / inertia with f of gravity, drag and wind at the start; x += h v. Pinned particles move as held.
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

/// Gauss-Seidel passes over the springs of a cloth: each spring in turn moves its two ends as if it were alone.
///
/// With C = |d| - L0 and the way dC that its ends have moved apart since the start of the step, a spring's multiplier q
/// [kg m] grows by
///     dq = -(h^2 k C + h c dC + q) / ((h^2 k + h c) (w_a + w_b) + 1)
/// and its ends move by w_a dq n and -w_b dq n. It is equation 26 of the paper, multiplied by h^2 k, which serves k = 0
/// and c = 0 as well. Where passes no longer change it, q is h^2 times the spring's force at the end of the step; its
/// ends have moved along the directions that the spring had on the way, which is what the method neglects.
///
/// The order is fixed: direction by direction, row by row; within a row, springs that share no particle are done at
/// once, which changes nothing but the speed. A spring of zero length waits until it has a direction.
/// @cite macklin2016
class SpringPasses {
public:
    SpringPasses(const Grid& grid, Kernels kernels)
        : grid_(grid), kernels_(kernels), weights_(grid.particles()), multipliers_(grid.particles(), 6) {}

    /// Starts a step of length h: forgets the multipliers.
    /// @param inertia of each particle, n x 1 [kg]
    void begin(const ClothModel& model, const Numbers& inertia, Real h) {
        h_ = h;
        weights_ = model.inverse_mass * (model.particle_mass / inertia);
        multipliers_.setZero();
    }

    /// One pass over the springs given.
    /// @param start n x 3 positions at the start of the step [m]
    /// @param x n x 3 [m], corrected
    /// @par Cost O(n), allocates nothing
    void pass(const std::array<SpringStencil, 6>& springs, const Points& start, Points& x) {
        DRAPE_ASSERT(start.rows() == grid_.particles() && x.rows() == grid_.particles());
        for (std::size_t direction = 0; direction < springs.size(); ++direction) {
            if (springs[direction].law == SpringLaw{}) continue;
            Real* const q = multipliers_.col(static_cast<Eigen::Index>(direction)).data();
            const StepSprings step{springs[direction], h_, weights_.data(), q};
            (kernels_ == Kernels::Plain ? correct_springs : kernels::correct_springs)(step, grid_, start, x);
        }
    }

private:
    /// Corrects the spring of ends a and b, by the formula above.
    static void correct_spring(const StepSprings& step, int a, int b, const Points& start, Points& x) {
        const Real hhk = step.h * step.h * step.springs.law.stiffness, hc = step.h * step.springs.law.damping;
        const Real w_a = step.weights[a], w_b = step.weights[b];
        const Vec3 d = x.row(a) - x.row(b), d_start = start.row(a) - start.row(b);
        const Real length = d.norm();
        if (length == 0) return;
        const Vec3 n = d / length;
        Real& q = step.multipliers[a];
        const Real c = length - step.springs.rest_length, dc = n.dot(d - d_start);
        const Real dq = -(hhk * c + hc * dc + q) / ((hhk + hc) * (w_a + w_b) + 1);
        q += dq;
        x.row(a) += w_a * dq * n.transpose();
        x.row(b) -= w_b * dq * n.transpose();
    }

    /// In the order of the kernel, which is that of Gauss-Seidel: it matters.
    static void correct_springs(const StepSprings& step, const Grid& grid, const Points& start, Points& x) {
        const SpringStencil& springs = step.springs;
        for (int j = 0; j < springs.rows(grid); ++j) {
            for (int first = 0; first < step.stride(); ++first) {
                for (int i = first; i < springs.count(grid); i += step.stride()) {
                    const int a = grid.particle(springs.first_column() + i, j);
                    correct_spring(step, a, a + springs.offset(grid), start, x);
                }
            }
        }
    }

    Grid grid_;
    Kernels kernels_;
    Real h_ = 0;
    Numbers weights_;                                    ///< n x 1: 1 / inertia, and 0 for a pinned particle
    Eigen::Array<Real, Eigen::Dynamic, 6> multipliers_;  ///< q of each direction's springs, at their first ends
};

}  // namespace drape
