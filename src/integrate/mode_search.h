#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

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
    ModeSearch(const ClothModel& model, const ClothState& state, Kernels kernels)
        : model_(model), jacobian_(model.grid, Hessian::Clamped, kernels) {
        jacobian_.linearise(model, state.x, state.v, true);
        for (Points* points : {&y_, &r_, &p_, &ay_, &ar_, &ap_}) points->setZero(model.grid.particles(), 3);
    }

    /// Goes on from the vector that was found last, with a little noise; ends after `turns`, or when the turns no
    /// longer gain anything.
    /// @return a k + b d of what was found
    Real maximise(Real a, Real b, int turns) {
        constexpr int patience = 6;
        constexpr Real worthwhile = Real(1e-5);
        add_noise(y_.isZero(0) ? Real(1) : Real(0.3));
        p_.setZero();
        ap_.setZero();
        apply(a, b, y_, ay_);
        normalise(y_, ay_);
        Real height = dot(y_, ay_);
        Real before = height;
        for (int turn = 1; turn <= turns; ++turn) {
            r_ = ay_ - height * y_;
            normalise(r_, ar_);
            apply(a, b, r_, ar_);

            // The last direction, without what y and r already have of it
            const Real in_y = dot(p_, y_), in_r = dot(p_, r_);
            p_ -= in_y * y_ + in_r * r_;
            ap_ -= in_y * ay_ + in_r * ar_;
            normalise(p_, ap_);

            take_best();
            height = dot(y_, ay_);
            if (turn % patience != 0) continue;
            if (!(height - before > worthwhile * std::abs(height))) break;
            before = height;
        }
        return height;
    }

    /// What was found last.
    [[nodiscard]] Mode mode() {
        apply(1, 0, y_, ar_);
        apply(0, 1, y_, ap_);
        const Real k = dot(y_, ar_), d = dot(y_, ap_);
        ar_ -= k * y_;
        ap_ -= d * y_;
        return {std::max(k, Real(0)), std::max(d, Real(0)), ar_.squaredNorm(), ap_.squaredNorm(), dot(ar_, ap_), y_};
    }

private:
    static Real dot(const Points& a, const Points& b) { return a.reshaped().dot(b.reshaped()); }

    /// Scales a vector and its image to norm 1; zero if there is nothing left of it.
    static void normalise(Points& u, Points& image) {
        const Real norm = u.norm();
        const Real scale = norm > std::sqrt(std::numeric_limits<Real>::min()) ? 1 / norm : Real(0);
        u *= scale;
        image *= scale;
    }

    void apply(Real a, Real b, const Points& u, Points& out) const {
        out.setZero();
        jacobian_.add_product(a, b, u, out);
        for (int axis = 0; axis < 3; ++axis) out.col(axis).array() *= model_.inverse_mass;
    }

    void add_noise(Real size) {
        std::mt19937 random(1);
        const Real scale = size / (std::sqrt(static_cast<Real>(y_.size())) * static_cast<Real>(std::mt19937::max()));
        for (Eigen::Index p = 0; p < y_.rows(); ++p) {
            for (int axis = 0; axis < 3; ++axis) {
                const Real draw = 2 * static_cast<Real>(random()) - static_cast<Real>(std::mt19937::max());
                if (!model_.pinned(static_cast<int>(p))) y_(p, axis) += scale * draw;
            }
        }
    }

    void take_best() {
        Eigen::Matrix<Real, 3, 3> products;
        products << dot(y_, ay_), 0, 0,                //
            dot(r_, ay_), dot(r_, ar_), 0,             //
            dot(p_, ay_), dot(p_, ar_), dot(p_, ap_);  // the solver reads the lower half
        // A direction of which nothing is left must not be taken for one of height 0, where all others are below
        const Real below = products(0, 0) - std::abs(products(0, 0)) - 1;
        if (r_.isZero(0)) products(1, 1) = below;
        if (p_.isZero(0)) products(2, 2) = below;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 3, 3>> solver(products);
        const Eigen::Matrix<Real, 3, 1> best = solver.eigenvectors().col(2);

        // What is added to y is the next direction
        p_ = best[1] * r_ + best[2] * p_;
        ap_ = best[1] * ar_ + best[2] * ap_;
        y_ = best[0] * y_ + p_;
        ay_ = best[0] * ay_ + ap_;
        normalise(y_, ay_);
    }

    const ClothModel& model_;
    Jacobian jacobian_;
    Points y_, r_, p_, ay_, ar_, ap_;
};

}  // namespace drape
