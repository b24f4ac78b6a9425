#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "drape/base/enum_names.h"
#include "drape/base/kernels.h"
#include "drape/model/cloth_model.h"
#include "drape/model/jacobian.h"

namespace drape {

/// The time integrators; names as in settings and files.
enum class IntegratorKind {
    ExplicitEuler,
    SymplecticEuler,
    VelocityVerlet,
    Rk4,
    BackwardEuler,
    ImplicitMidpoint,
    Bdf2,
    Xpbd,
    ProjectiveDynamics,
    DormandPrince
};

/// What an integrator is made from; each reads what concerns it.
struct IntegratorParameters {
    IntegratorKind integrator = IntegratorKind::VelocityVerlet;
    Hessian hessian = Hessian::Clamped;  ///< of backward Euler, implicit midpoint and BDF2
    int iterations = 10;                 ///< of XPBD and projective dynamics in one step
    Real tolerance = 0;                  ///< see `tolerance_of`; 0: the method's own
    int newton_steps = 1;                ///< of the implicit methods in one step, at most; 1: as if linear
    int threads = 1;                     ///< that share forces and multigrid; the result is the same
    Kernels kernels = Kernels::Vector;   ///< of forces, Jacobians and the springs of XPBD
    bool operator==(const IntegratorParameters&) const = default;
};

/// To what a method solves: a linear solve, as a part of its right side, or for Dormand-Prince the error of a step, as
/// a part of the cloth's spacing. Backward Euler and BDF2 have 1e-4 of their own, far below the error of their step;
/// implicit midpoint, which damps nothing, and Dormand-Prince 1e-6; the exact Hessian, which is for accuracy, 1e-8.
/// Single precision has 1e-4. What the others are told has no meaning.
Real tolerance_of(const IntegratorParameters& parameters);

/// The most inner steps that Dormand-Prince tries in one step, taken and rejected: then it gives up.
constexpr int max_inner_steps = 10'000;

/// What an integrator tells about one step.
///
/// The residual is what a method should have made small, as it measures it at the end:
/// - backward Euler, implicit midpoint, BDF2: |b - A x| / |b|, in the Euclidean norm over all free particles, of the
///   linear systems A x = b of a step. (What Newton steps leave of the nonlinear equations is not measured.)
///   Exact, the solver stops in that same norm. Clamped, it stops in the norm of its preconditioner M, sqrt(r.M^-1 r)
///   against that of b, which weighs soft directions more: there the Euclidean residual of a solve that has converged
///   can be above the tolerance.
/// - Dormand-Prince: the largest error estimate of an inner step that was taken, of the cloth's spacing; the tolerance
///   is that of `tolerance_of`, as everywhere.
/// - Projective dynamics makes a fixed number of rounds, whether they are enough or not: the norm of the gradient that
///   the last round began with, which is the force that is not balanced, over that of the external forces or of what
///   has accelerated the cloth, whichever is more; the tolerance is 0.05. Long steps on stiff cloth need more than ten
///   rounds.
/// - XPBD makes a fixed number of passes and would need another one to know what they have left: it has no residual and
///   is never counted as unconverged, which says nothing about how soft it has left the springs. 0, as for the explicit
///   methods, which solve nothing.
struct SolveReport {
    int force_evaluations = 0;
    int iterations = 0;    ///< of conjugate gradients, XPBD, projective dynamics, or inner steps of Dormand-Prince
    Real residual = 0;     ///< the largest
    Real tolerance = 0;    ///< to which it should have come; 0: there is none
    int unconverged = 0;   ///< solves that have not converged, see `krylov`, or inner steps taken above the tolerance
    bool gave_up = false;  ///< the step has not been made; the state is somewhere on the way

    SolveReport& operator+=(const SolveReport& other) {
        force_evaluations += other.force_evaluations;
        iterations += other.iterations;
        if (!(other.residual <= residual)) residual = other.residual;  // one that is no number stays in sight
        tolerance = std::max(tolerance, other.tolerance);
        unconverged += other.unconverged;
        gave_up = gave_up || other.gave_up;
        return *this;
    }
};

/// What a method knows of the step before, beside the state: nothing, for all but BDF2.
struct StepBefore {
    ClothState from, to;
    Real h = 0;                  ///< [s]; 0: nothing is known
    std::uint64_t revision = 0;  ///< of the model
};

/// Advances a cloth by one step from its state, so that the kind can change between any two steps. BDF2 alone also uses
/// the state before; where the state was changed from outside, it restarts with backward Euler.
class Integrator {
public:
    virtual ~Integrator() = default;

    [[nodiscard]] virtual StepBefore step_before() const { return {}; }

    /// Goes on as another one of the same parameters would, to the bit.
    virtual void resume_after(const StepBefore& /*step*/) {}

    /// @param state advanced in place; pinned particles keep their velocity (zero, or that of the hand that holds them)
    /// @param h step [s]
    /// @par Cost O(n) a force evaluation, iteration or round; where a matrix is factored, O(n^1.5). Allocates nothing
    /// once there has been a step of the same kind, but for the factors of projective dynamics
    virtual SolveReport step(const ClothModel& model, ClothState& state, Real h) = 0;
};

/// What a method keeps to solve with.
enum class Keeps {
    Nothing,
    NewtonSystem,  ///< a linear system with the Jacobian of the forces: backward Euler, implicit midpoint, BDF2
    ScalarFactors
};

/// The longest step of a method for a vibration x'' = -k x - d x', where k and d are not both 0 [s].
/// @param k [1/s^2], d [1/s]
using LongestStep = double (*)(double k, double d);

/// All that has to be known of a kind of integrator: its row in the table of `method_of`.
struct MethodRow {
    std::unique_ptr<Integrator> (*make)(const IntegratorParameters& parameters, const Grid& grid);
    LongestStep longest_step = nullptr;  ///< null where no step is too long
    double displacement = 1;             ///< see `displacement_factor`
    double tolerance = 0;                ///< see `tolerance_of`; of a linear solve, with the clamped Hessian
    double numbers;                      ///< a particle, of the arrays that its class has: three for each of Points
    Keeps keeps = Keeps::Nothing;
    bool iterates = false;  ///< as many times as `IntegratorParameters::iterations` says
};

const MethodRow& method_of(IntegratorKind kind);

/// By how much a constant force displaces a particle at rest within a step h, of h times the velocity that it gives:
/// 1/2 where a step is exact for it, else 1. (Explicit Euler, which displaces it in the next step only, counts as 1.)
Real displacement_factor(IntegratorKind kind);

/// @param grid of the cloths it will step; the scratch arrays are made here
std::unique_ptr<Integrator> make_integrator(const IntegratorParameters& parameters, const Grid& grid);

/// About what an integrator takes at most, in making and stepping, for one cloth [bytes].
double bytes_of_method(const IntegratorParameters& parameters, const Grid& grid);

}  // namespace drape
