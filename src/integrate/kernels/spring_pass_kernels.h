#pragma once

#include "drape/model/stencils.h"

namespace drape {

/// The springs of one direction in one step of XPBD; n x 1 arrays.
struct StepSprings {
    SpringStencil springs;
    Real h;               ///< [s]
    const Real* weights;  ///< 1 / inertia [1/kg], and 0 for a pinned particle
    Real* multipliers;    ///< q [kg m], at the springs' first ends

    /// In a row of springs, every so many share no particle.
    [[nodiscard]] int stride() const { return springs.dj > 0 ? 1 : 2 * springs.di; }
};

namespace kernels {

/// Corrects the springs of one direction, row by row, and in a row those at once that share no particle.
/// @param start, x n x 3 positions at the start of the step, and now [m]
void correct_springs(const StepSprings& step, const Grid& grid, const Points& start, Points& x);

}  // namespace kernels
}  // namespace drape
