#pragma once

#include <array>

#include "drape/base/kernels.h"
#include "drape/model/stencils.h"

namespace drape {

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
    SpringPasses(const Grid& grid, Kernels kernels);

    /// Starts a step of length h: forgets the multipliers.
    /// @param inertia of each particle, n x 1 [kg]
    void begin(const ClothModel& model, const Eigen::Array<Real, Eigen::Dynamic, 1>& inertia, Real h);

    /// One pass over the springs given.
    /// @param start n x 3 positions at the start of the step [m]
    /// @param x n x 3 [m], corrected
    /// @par Cost O(n), allocates nothing
    void pass(const std::array<SpringStencil, 6>& springs, const Points& start, Points& x);

private:
    Grid grid_;
    Kernels kernels_;
    Real h_ = 0;
    Eigen::Array<Real, Eigen::Dynamic, 1> weights_;      ///< n x 1: 1 / inertia, and 0 for a pinned particle
    Eigen::Array<Real, Eigen::Dynamic, 6> multipliers_;  ///< q of each direction's springs, at their first ends
};

}  // namespace drape
