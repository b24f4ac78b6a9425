#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "drape/integrate/integrator.h"
#include "drape/model/force_sweep.h"
#include "drape/model/jacobian.h"
#include "grid_factor.h"
#include "krylov.h"
#include "multigrid.h"
#include "symmetric_blocks.h"

namespace drape {

/// The linear system of one Newton step of an implicit method, (m I + s D + s^2 K) dv = r, for the free particles;
/// dv of a pinned one is zero.
///
/// Clamped, the matrix is positive definite, and conjugate gradients solve it. Exact, it is neither symmetric (the
/// damping's x-derivative) nor always positive definite (compressed springs), and stabilised biconjugate gradients do.
/// Both are preconditioned: by the factors L D L' of the symmetric part, which ends them after one to four iterations
/// and is a direct solve of the clamped system; by the inverses of the 3 x 3 diagonal blocks, which cost next to
/// nothing; or, of the clamped one, by a cycle of multigrid, with which stiff systems on large grids take few
/// iterations. Small grids are factored, for accuracy; on larger ones the blocks and multigrid are far quicker.
/// There the exact system falls back on factors where the blocks do not converge, on grids up to
/// `GridFactor::largest`; on still larger ones the report tells. Sums run in a fixed order, and nothing is kept from
/// one step to the next. Norms and tolerances are those that `SolveReport` describes.
class NewtonSystem {
public:
    NewtonSystem(const Grid& grid, const IntegratorParameters& parameters)
        : tolerance_(tolerance_of(parameters)),
          newton_steps_(parameters.newton_steps),
          max_momentum_change_(parameters.integrator == IntegratorKind::ImplicitMidpoint ? 2 : 8),
          forces_(grid, parameters.kernels, parameters.threads),
          jacobian_(grid, parameters.hessian, parameters.kernels, parameters.threads),
          inverse_(grid.particles(), 6),
          x_(grid.particles(), 3),
          conjugate_gradients_(grid.particles()) {
        pinned_.reserve(static_cast<std::size_t>(grid.particles()));
        if (parameters.hessian == Hessian::Exact) bicgstab_ = std::make_unique<krylov::BiCgStab>(grid.particles());
        if (keeps_factors(grid, parameters.hessian)) factor_ = std::make_unique<GridFactor>(grid);
        if (refines()) {
            for (Points* scratch : {&left_, &step_, &tried_, &v_}) scratch->resize(grid.particles(), 3);
        }
        if (parameters.hessian == Hessian::Clamped && grid.particles() >= many_particles) {
            multigrid_ = std::make_unique<Multigrid>(grid, parameters.kernels, parameters.threads);
        }
    }

    /// Whether a system over this grid keeps factors, which is most of its memory.
    static bool keeps_factors(const Grid& grid, Hessian hessian) {
        const bool falls_back = hessian == Hessian::Exact && grid.particles() <= GridFactor::largest;
        return grid.particles() <= few_particles || falls_back;
    }

    /// The force where a step leads with the velocities as they are, f(x + dx, v), and its Jacobians: a Newton step
    /// from there is of second order, whatever the Hessian leaves out. Springs that vibrate faster than the step can
    /// follow make it a bad place to begin at, which is seen by the force: within the step it would change the cloth's
    /// momentum many times over. Then the force is that of the start, to first order f(x, v) - K dx. So it is near rest
    /// too, where both are nearly the same.
    /// @param dx n x 3 [m], pinned particles included: a hand that moves one pulls at its neighbours
    /// @param s as in `solve`
    /// @param f n x 3 [N], overwritten; zero at pinned particles
    /// @return how often forces were evaluated
    int linearise_ahead(const ClothModel& model, const ClothState& state, const Points& dx, Real s, Points& f) {
        pinned_.clear();
        for (int p = 0; p < model.grid.particles(); ++p) {
            if (model.pinned(p)) pinned_.push_back(p);
        }
        x_ = state.x + dx;
        forces_.compute(model, x_, state.v, f);
        clear_pinned(f);
        if (s * spread(model, f) <= max_momentum_change_ * model.particle_mass * spread(model, state.v)) {
            jacobian_.linearise(model, x_, state.v);
            return 1;
        }
        forces_.compute(model, state.x, state.v, f);
        jacobian_.linearise(model, state.x, state.v);
        jacobian_.add_product(-1, 0, dx, f);
        clear_pinned(f);
        return 2;
    }

    /// @param s the weight of the new velocity in the step [s]
    /// @param r n x 3 [N s], set to zero at pinned particles
    /// @param dv n x 3 [m/s], overwritten
    SolveReport solve(const ClothModel& model, Real s, Points& r, Points& dv) {
        clear_pinned(r);
        const auto apply = [&](const Points& u, Points& y) {
            y = model.particle_mass * u;
            jacobian_.add_product(s * s, s, u, y);
            clear_pinned(y);
        };
        int iterations = 0;  // of all attempts
        const auto solve_with = [&](int limit, auto precondition) {
            SolveReport report = bicgstab_ ? bicgstab_->solve(r, dv, tolerance_, limit, apply, precondition)
                                           : conjugate_gradients_.solve(r, dv, tolerance_, limit, apply, precondition);
            report.iterations = iterations += report.iterations;
            return report;
        };
        if (multigrid_ && is_stiff(model, s)) {
            multigrid_->build(model, jacobian_, s * s, s);
            const SolveReport report =
                solve_with(max_cycles, [&](const Points& from, Points& to) { multigrid_->cycle(from, to); });
            if (report.unconverged == 0) return report;
        }
        if (model.grid.particles() > few_particles) {
            invert_diagonal(model, s);
            const SolveReport report = solve_with(
                factor_ ? patience(model.grid.particles()) : max_iterations,
                [&](const Points& from, Points& to) { multiply_blocks(inverse_, from.array(), to.array()); });
            if (!factor_ || report.unconverged == 0) return report;
        }
        factor_->factorise(model, jacobian_, s * s, s);
        return solve_with(refinements, [&](const Points& from, Points& to) { factor_->solve(from, to); });
    }

    /// Whether further Newton steps are asked for.
    [[nodiscard]] bool refines() const { return newton_steps_ > 1; }

    /// Makes the further Newton steps that are asked for towards m dv = s / theta f(x + s theta dv, v + theta dv), each
    /// from where the one before has come to. A step that leaves more of the equations is halved; where that does not
    /// help, this ends.
    /// @param x, v where the forces are taken for dv = 0, n x 3 [m], [m/s]
    /// @param theta the part of dv that counts there; s as in `solve`
    /// @param dv n x 3 [m/s], that the first step has found
    /// @cite nocedal2006
    SolveReport refine(const ClothModel& model, const Points& x, const Points& v, Real s, Real theta, Points& dv) {
        SolveReport all;
        const auto left_at = [&](const Points& at) {
            x_ = x + (s * theta) * at;
            v_ = v + theta * at;
            forces_.compute(model, x_, v_, left_);
            ++all.force_evaluations;
            left_ = (s / theta) * left_ - model.particle_mass * at;
            clear_pinned(left_);
            return left_.norm();
        };
        Real left = left_at(dv);
        for (int made = 1; made < newton_steps_; ++made) {
            jacobian_.linearise(model, x_, v_);
            all += solve(model, s, left_, step_);
            const Real before = left;
            Real part = 1;
            do {
                tried_ = dv + part * step_;
                left = left_at(tried_);
                part /= 2;
            } while (!(left < before) && part > shortest_part);
            if (!(left < before)) break;
            dv = tried_;
        }
        return all;
    }

private:
    /// Up to so many particles factors come first: they cost a fraction of a millisecond and solve to rounding.
    /// Iterations are quicker at any size, by 1.5 times for springs of 1e6 N/m at 1/20 s up to forty for gentle steps.
    static constexpr int few_particles = 64;

    /// Where there are no factors to fall back on, a solve ends after so many iterations with what it has.
    static constexpr int max_iterations = 5000;

    /// Where there are, it ends after about half of what the factors cost, which grows with n^1.5 as n^0.5 iterations
    /// do.
    static int patience(int particles) { return static_cast<int>(8 * std::sqrt(static_cast<Real>(particles))); }

    /// From so many particles on there is multigrid, and it is used for systems whose condition's root is at least
    /// this. With the diagonal blocks alone about twice as many iterations are needed, and 60 take as long as four with
    /// cycles and their set-up. Measured at 32 to 128 particles a side.
    static constexpr int many_particles = 400;
    static constexpr Real stiff = 30;

    /// Where so many cycles do not do, single precision is not enough, and the diagonal blocks are left to it.
    static constexpr int max_cycles = 100;

    /// Of a Newton step, that is tried before it is given up.
    static constexpr Real shortest_part = Real(0.05);

    /// With factors few iterations are needed, or many do not help.
    static constexpr int refinements = 50;

    /// The matrix is between its inertia and what four springs of each kind at both ends add to that.
    [[nodiscard]] bool is_stiff(const ClothModel& model, Real s) const {
        Real springs = 0;
        for (const SpringLaw& law : {model.structural, model.shear, model.bend}) {
            springs += 8 * (s * s * law.stiffness + s * law.damping);
        }
        return springs > stiff * stiff * (model.particle_mass + s * jacobian_.drag());
    }

    /// How far some vectors of the free particles are from their mean: the root of the sum of squares.
    static Real spread(const ClothModel& model, const Points& vectors) {
        Vec3 sum = Vec3::Zero();
        Real squares = 0;
        int count = 0;
        for (int p = 0; p < model.grid.particles(); ++p) {
            if (model.pinned(p)) continue;
            const Vec3 one = vectors.row(p);
            sum += one;
            squares += one.squaredNorm();
            ++count;
        }
        return std::sqrt(std::max(squares - sum.squaredNorm() / static_cast<Real>(std::max(count, 1)), Real(0)));
    }

    void clear_pinned(Points& points) const {
        for (const int p : pinned_) points.row(p).setZero();
    }

    void invert_diagonal(const ClothModel& model, Real s) {
        const Real own = model.particle_mass + s * jacobian_.drag();
        inverse_.leftCols<1>().setConstant(own);
        inverse_.rightCols<5>().setZero();
        inverse_.col(3).setConstant(own);
        inverse_.col(5).setConstant(own);
        jacobian_.for_each_block(s * s, s, [&](int a, int b, const Jacobian::Block& block) {
            if (a == b) add_block(inverse_, a, block);
        });
        for (Eigen::Index p = 0; p < inverse_.rows(); ++p) {
            const auto [adjugate, determinant] = adjugate_of<Real>(inverse_.row(p));
            const Real scale = 1 / determinant;
            for (Eigen::Index e = 0; e < 6; ++e) inverse_(p, e) = scale * adjugate[static_cast<std::size_t>(e)];
        }
        for (const int p : pinned_) inverse_.row(p).setZero();
    }

    Real tolerance_;
    int newton_steps_;
    /// How many times the cloth's momentum the force ahead may change it by, both without what all particles share.
    /// Beyond some of this, stiff sheets gain energy in long steps. Midpoint damps nothing, not even what a bad
    /// beginning leaves.
    Real max_momentum_change_;
    ForceSweep forces_;
    Jacobian jacobian_;
    std::unique_ptr<GridFactor> factor_;    ///< where it can be wanted
    std::unique_ptr<Multigrid> multigrid_;  ///< likewise
    std::vector<int> pinned_;
    Eigen::Array<Real, Eigen::Dynamic, 6> inverse_;  ///< xx, xy, xz, yy, yz, zz of each diagonal block's inverse
    Points x_;                                       ///< where forces are taken, n x 3
    krylov::ConjugateGradients conjugate_gradients_;
    std::unique_ptr<krylov::BiCgStab> bicgstab_;

    /// Of further Newton steps: what is left of the equations, a step, where it leads, and its velocities
    Points left_, step_, tried_, v_;
};

}  // namespace drape
