#pragma once

#include <algorithm>
#include <cmath>

#include "drape/integrate/integrator.h"

/// Solvers of linear systems. Their reports have the residual |b - A x| / |b|, measured at the end, for that of the
/// recursion drifts. Conjugate gradients have converged where their recursion has, in the norm that they stop in, and
/// the residual is within the tolerance or within `drift` times that of the recursion; biconjugate gradients, where it
/// is within `drift` times the tolerance. They stop at a residual so much smaller than the right side as the tolerance
/// says, in their own norm, or after `max_iterations`.
namespace drape::krylov {

/// What is measured at the end may be this many times as much: the recursion that stops a solver drifts.
constexpr Real drift = 2;

inline Real dot(const Points& a, const Points& b) { return a.cwiseProduct(b).sum(); }

/// |b - A x| / |b|, and 0 for b = 0; scratch is A x afterwards.
template <class Apply>
Real residual_of(const Points& b, const Points& x, Apply apply, Points& scratch) {
    apply(x, scratch);
    const Real size = b.norm();
    return size == 0 ? Real(0) : (b - scratch).norm() / size;
}

/// Solves A x = b, for a symmetric positive definite A, by preconditioned conjugate gradients.
///
/// Eigen's own allocates its vectors in every solve and wants a matrix; this one keeps them, and calls apply(u, y) for
/// y = A u and precondition(r, z) for z = M^-1 r. With the exact inverse for M it ends after one iteration. It stops in
/// the norm sqrt(r.M^-1 r), which it has at hand. Where A or M turns out not to be positive definite, it ends with what
/// it has, unconverged. Legend as in the source: r residual, p direction, q = A p, z = M^-1 r.
/// @cite shewchuk1994
class ConjugateGradients {
public:
    explicit ConjugateGradients(int particles)
        : r_(particles, 3), p_(particles, 3), q_(particles, 3), z_(particles, 3) {}

    template <class Apply, class Precondition>
    SolveReport solve(const Points& b, Points& x, Real tolerance, int max_iterations, Apply apply,
                      Precondition precondition) {
        x.setZero();
        r_ = b;
        precondition(r_, z_);
        p_ = z_;
        Real rz = dot(r_, z_);
        const Real enough = tolerance * tolerance * std::max(rz, Real(0));
        SolveReport report{.tolerance = tolerance};
        while (rz > enough && report.iterations < max_iterations) {
            apply(p_, q_);
            const Real alpha = rz / dot(p_, q_);
            if (!(alpha > 0)) break;
            x += alpha * p_;
            r_ -= alpha * q_;
            precondition(r_, z_);
            const Real before = rz;
            rz = dot(r_, z_);
            p_ = z_ + (rz / before) * p_;
            ++report.iterations;
        }
        const Real recursive = r_.norm(), size = b.norm();
        report.residual = residual_of(b, x, apply, q_);
        const bool drifted = !(report.residual <= std::max(tolerance, drift * recursive / size));
        report.unconverged = rz >= 0 && rz <= enough && !drifted ? 0 : 1;
        return report;
    }

private:
    Points r_, p_, q_, z_;
};

/// Solves A x = b for any A, by the preconditioned stabilised method of biconjugate gradients. Where it breaks down it
/// stops at what it has, and the residual tells. It stops in the Euclidean norm.
/// Legend as in the source: r residual, r0 its shadow, p and s directions, v = A M^-1 p, t = A M^-1 s.
/// @cite vandervorst1992
class BiCgStab {
public:
    explicit BiCgStab(int particles)
        : r_(particles, 3), r0_(particles, 3), p_(particles, 3), v_(particles, 3), t_(particles, 3), y_(particles, 3) {}

    template <class Apply, class Precondition>
    SolveReport solve(const Points& b, Points& x, Real tolerance, int max_iterations, Apply apply,
                      Precondition precondition) {
        x.setZero();
        r_ = r0_ = p_ = b;
        const Real enough = tolerance * b.norm();
        Real rho = dot(r0_, r_), residual = b.norm();
        SolveReport report{.tolerance = tolerance};
        while (residual > enough && report.iterations < max_iterations) {
            ++report.iterations;
            precondition(p_, y_);
            apply(y_, v_);
            const Real alpha = rho / dot(r0_, v_);
            if (!std::isfinite(alpha)) break;
            x += alpha * y_;
            r_ -= alpha * v_;  // s of the source
            precondition(r_, y_);
            apply(y_, t_);
            const Real tt = dot(t_, t_), omega = tt > 0 ? dot(t_, r_) / tt : Real(0);
            x += omega * y_;
            r_ -= omega * t_;
            residual = r_.norm();
            const Real before = rho;
            rho = dot(r0_, r_);
            if (omega == 0 || rho == 0) break;
            const Real beta = rho / before * (alpha / omega);
            p_ = r_ + beta * (p_ - omega * v_);
        }
        report.residual = residual_of(b, x, apply, v_);
        report.unconverged = report.residual <= drift * tolerance ? 0 : 1;
        return report;
    }

private:
    Points r_, r0_, p_, v_, t_, y_;
};

}  // namespace drape::krylov
