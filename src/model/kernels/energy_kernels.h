#pragma once

#include "drape/model/stencils.h"

namespace drape {

/// What the springs of one direction add up to.
struct SpringSums {
    double squared_elongations = 0;     ///< of (|d| - L0)^2 [m^2]
    double squared_closing_speeds = 0;  ///< of (n.(v_a - v_b))^2; without a direction a spring adds nothing [m^2/s^2]
};

/// What some particles add up to.
struct ParticleSums {
    Eigen::Vector3d positions = Eigen::Vector3d::Zero();  ///< [m]
    double squared_speeds = 0;                            ///< [m^2/s^2]
};

namespace kernels {

/// Sums run in eight lanes, whatever the width of the vectors.
SpringSums sum_over_springs(const SpringStencil& springs, const Grid& grid, const Points& x, const Points& v);
ParticleSums sum_over_particles(const Grid& grid, const Points& x, const Points& v);

}  // namespace kernels
}  // namespace drape
