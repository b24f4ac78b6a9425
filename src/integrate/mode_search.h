#pragma once

#include "drape/model/jacobian.h"

namespace drape {

/// A vibration y of a cloth, as its Rayleigh quotients.
struct Mode {
    Real stiffness = 0;  ///< y'Ky / y'My [1/s^2], the square of its frequency
    Real damping = 0;    ///< y'Dy / y'My [1/s]
    // What y is short of being an eigenvector of both, for y of length 1 by mass
    Real stiffness_variance = 0;  ///< |Ky - ky|^2 [1/s^4]
    Real damping_variance = 0;    ///< |Dy - dy|^2 [1/s^2]
    Real covariance = 0;          ///< (Ky - ky)'(Dy - dy) [1/s^3]
    Points shape = {};            ///< y, n x 3, its norm is 1; exactly 0 at pins
};

/// Looks for the vibration of the free particles that has the largest a k + b d, where k and d are those of `Mode`.
///
/// Locally optimal conjugate gradients: each turn takes the best vector of the space of y, the gradient r at y, and the
/// last direction p. It comes as near as Lanczos' method in as many products, needs three vectors, and has y at hand.
/// Invariant: y, p and r have norm 1 or 0 and are orthogonal.
/// @cite knyazev2001
class ModeSearch {
public:
    /// Starts at a random vector, always the same.
    ModeSearch(const ClothModel& model, const ClothState& state, Kernels kernels);

    /// Goes on from the vector that was found last, with a little noise; ends after `turns`, or when the turns no
    /// longer gain anything.
    /// @return a k + b d of what was found
    Real maximise(Real a, Real b, int turns);

    /// What was found last.
    [[nodiscard]] Mode mode();

private:
    void apply(Real a, Real b, const Points& u, Points& out) const;
    void add_noise(Real size);
    void take_best();

    const ClothModel& model_;
    Jacobian jacobian_;
    Points y_, r_, p_, ay_, ar_, ap_;
};

}  // namespace drape
