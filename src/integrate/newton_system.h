#pragma once

#include <memory>
#include <vector>

#include "drape/integrate/integrator.h"
#include "drape/model/force_sweep.h"
#include "drape/model/jacobian.h"
#include "grid_factor.h"
#include "krylov.h"
#include "multigrid.h"

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
/// `GridFactor::largest`; on still larger ones the outcome tells. Sums run in a fixed order, and nothing is kept from
/// one step to the next. Norms and tolerances are those that `SolveReport` describes.
class NewtonSystem {
public:
    NewtonSystem(const Grid& grid, const IntegratorParameters& parameters);

    /// Whether a system over this grid keeps factors, which is most of its memory.
    static bool keeps_factors(const Grid& grid, Hessian hessian);

    /// Likewise multigrid.
    static bool keeps_multigrid(const Grid& grid, Hessian hessian);

    /// The force where a step leads with the velocities as they are, f(x + dx, v), and its Jacobians: a Newton step
    /// from there is of second order, whatever the Hessian leaves out. Springs that vibrate faster than the step can
    /// follow make it a bad place to begin at, which is seen by the force: within the step it would change the cloth's
    /// momentum many times over. Then the force is that of the start, to first order f(x, v) - K dx. So it is near rest
    /// too, where both are nearly the same.
    /// @param dx n x 3 [m], pinned particles included: a hand that moves one pulls at its neighbours
    /// @param s as in `solve`
    /// @param f n x 3 [N], overwritten; zero at pinned particles
    /// @return how often forces were evaluated
    int linearise_ahead(ForceSweep& forces, const ClothModel& model, const ClothState& state, const Points& dx, Real s,
                        Points& f);

    /// @param s the weight of the new velocity in the step [s]
    /// @param r n x 3 [N s], set to zero at pinned particles
    /// @param dv n x 3 [m/s], overwritten
    krylov::Outcome solve(const ClothModel& model, Real s, Points& r, Points& dv);

    /// Whether further Newton steps are asked for.
    [[nodiscard]] bool refines() const { return newton_steps_ > 1; }

    /// Makes the further Newton steps that are asked for towards m dv = s / theta f(x + s theta dv, v + theta dv), each
    /// from where the one before has come to. A step that leaves more of the equations is halved; where that does not
    /// help, this ends.
    /// @param x, v where the forces are taken for dv = 0, n x 3 [m], [m/s]
    /// @param theta the part of dv that counts there; s as in `solve`
    /// @param dv n x 3 [m/s], that the first step has found
    /// @cite nocedal2006
    SolveReport refine(ForceSweep& forces, const ClothModel& model, const Points& x, const Points& v, Real s,
                       Real theta, Points& dv);

    /// The report of a step of so many force evaluations and this solve.
    [[nodiscard]] SolveReport report(int force_evaluations, const krylov::Outcome& solved) const;

private:
    [[nodiscard]] bool is_stiff(const ClothModel& model, Real s) const;
    void clear_pinned(Points& points) const;
    void invert_diagonal(const ClothModel& model, Real s);
    void apply_inverse_diagonal(const Points& r, Points& z) const;

    Real tolerance_;
    int newton_steps_;
    Real max_momentum_change_;
    bool factors_first_;
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
