#pragma once

#include <functional>

#include "drape/base/enum_names.h"
#include "drape/integrate/integrator.h"

namespace drape {

/// For so many steps a step size is tried, if nothing else is said.
inline constexpr int tried_steps = 3000;

/// How a trial ended.
enum class TrialEnd {
    Bounded,     ///< all steps done
    NotFinite,   ///< a position or velocity is no number any more
    EnergyRose,  ///< the motion alone has more than M g L: the whole cloth lifted by the diagonal of its sheet
    OutOfReach,  ///< a particle is farther from its start than any of a cloth of the same size can get: twice the
                 ///< diagonal
    Stretched    ///< the energy rose above that of the start by M g L, but the motion never had as much: nothing
                 ///< grows, but the method leaves springs longer than their forces allow
};

/// The rise of its energy by which a cloth counts as diverged: M g L, with the earth's g whether or not it feels it
/// [J].
Real energy_to_fail(const ClothModel& model);

/// Runs a cloth with one step size, from a state with noise on it: symmetry would hide the vibrations that grow. The
/// state is looked at every few steps, and after the last.
/// @return Bounded if it stays so for all steps
TrialEnd try_step(const ClothModel& model, ClothState start, const IntegratorParameters& parameters, Real step,
                  int steps = tried_steps);

/// The longest step that stays bounded, by bisection to half a percent.
/// @param guess where the search starts [s]; the bounds are doubled and halved from it until one fails and one does
/// not. If it is not positive, the search starts at 1 s.
/// @param tried told of every step that was tried; may be empty
/// @return [s]; infinite if none up to a second fails, 0 if none does not
Real measured_limit(const ClothModel& model, const ClothState& start, const IntegratorParameters& parameters,
                    Real guess, int steps = tried_steps, const std::function<void(Real, TrialEnd)>& tried = {});

/// The step at which explicit Euler's growth shows in a trial. It damps no vibration beyond its limit d/k, but is slow
/// to show that: N steps h multiply the energy of one by (1 - h d + h^2 k)^N, and the trial ends where this is as much
/// as the start's energy, that of the noise, lacks to the one that is judged a failure. So the observed limit depends
/// on the number of steps and on the noise:
///
///     h = (d + sqrt(d^2 + 4 k (G^(1/N) - 1))) / (2 k)   with G = (energy that fails) / (energy of the noise)
///
/// Beyond zeta = 1 it is the limit itself: there a decay turns into growth at once.
/// @param omega, zeta of the fastest vibration, as `predicted_limit` gives them for another explicit method
/// @return [s]
Real observable_limit_of_explicit_euler(const ClothModel& model, const ClothState& start, Real omega, Real zeta,
                                        Kernels kernels, int steps = tried_steps);

}  // namespace drape
