#pragma once

#include "drape/integrate/integrator.h"

namespace drape {

/// What the longest stable step of a method follows from.
struct StepLimit {
    Real omega = 0;         ///< angular frequency of the vibration that grows first [1/s]; 0 without springs
    Real zeta = 0;          ///< its damping ratio: its damping by mass over 2 omega
    Real step = 0;          ///< [s]; 0 if no step is stable, infinite if none is too long
    bool at_least = false;  ///< no vibration was found that keeps a longer step from being stable
};

/// The longest step with which a method keeps small vibrations of a cloth about a state from growing.
///
/// Stiffness K and damping D are taken where the cloth is, with the clamped Hessian: a spring that is pushed together
/// counts without its negative stiffness across, so that what remains is bound to vibrate and the limit errs, if at
/// all, to the safe side. At rest, and wherever springs only pull, it is the exact one. Where wind blows, D has what it
/// resists by as if it met every triangle along its normal: no turn of the cloth makes the limit shorter. In strong
/// wind implicit midpoint has a limit too, a rough one (`longest_of_midpoint`).
///
/// A vibration y counts by k = y'Ky / y'My and d = y'Dy / y'My alone, from which its limit follows (`longest_step`).
/// Every eigenvalue lambda of lambda^2 M + lambda D + K is that of the k and d of some complex y, so no step below the
/// least limit over all y makes a vibration grow. The pairs (k, d) of all y fill a convex set, which is enclosed by as
/// many lines as it takes. Symplectic Euler's limit is exactly that, for any K and D. For the other methods it is where
/// the y that decides is a vibration by itself: always where damping is proportional to stiffness, and nearly so for
/// light damping with a limit at the highest frequency. Where it is not, the result is flagged as `at_least`: explicit
/// Euler's may then be far too careful.
///
/// The fastest waves are a cell or two long. A cloth of more than 64 particles a side is therefore searched in windows
/// of that size, and closely in the one where they are fastest; that leaves omega at most about 0.2 % too low.
/// @cite johnson1978
/// @par Cost 2 to 3 ms at 30 x 30, two to four times that where kinds of springs are damped unlike each other;
/// 0.5 s and more at 1024 x 1024; nothing for a method without a limit; allocates
StepLimit predicted_limit(const ClothModel& model, const ClothState& state, IntegratorKind kind, Kernels kernels);

/// A limit with the vibration that it is the limit of.
struct LimitingMode {
    StepLimit limit;
    /// n x 3 displacements of norm 1, exactly 0 at pins; empty or zero where no vibration limits the step
    Points shape;
};

/// The limit as `predicted_limit`, and the mode that grows first beyond it. Where the limit is flagged as `at_least`,
/// that of all vibrations that were found which has the shortest limit by itself.
/// @par Cost that of `predicted_limit`
LimitingMode limiting_mode(const ClothModel& model, const ClothState& state, IntegratorKind kind, Kernels kernels);

/// The longest stable step for x'' = -k x - d x'.
///
/// Explicit Euler: d/k up to zeta = 1, then 2 over the faster of both decays. Symplectic Euler: 4 / (d + sqrt(d^2 + 4
/// k)), which is z = 2 (sqrt(1 + zeta^2) - zeta). Velocity Verlet: 4 / (d + sqrt(4 k - 3 d^2)) up to zeta = 1/2, then
/// 2/d. RK4: where its amplification reaches 1, which undamped is z = 2 sqrt(2).
/// @param k [1/s^2], d [1/s]
/// @return [s]; infinite for the other methods, and if both are 0
double longest_step(IntegratorKind kind, double k, double d);

/// True for the methods whose step has a limit: the explicit ones with a fixed step.
bool has_step_limit(IntegratorKind kind);

}  // namespace drape
