#pragma once

#include "drape/base/snapshot_text.h"
#include "drape/model/cloth_model.h"
#include "drape/model/energy.h"

namespace drape {

/// The sums over a cloth's particles that are wanted after every substep.
struct MotionSums {
    Vec3 positions = Vec3::Zero();   ///< [m]
    Vec3 velocities = Vec3::Zero();  ///< [m/s]
    Real squared_speeds = 0;         ///< [m^2/s^2]
};

/// @par Cost O(n), allocates nothing
MotionSums sum_motion(const ClothState& state);

/// Sees to it that a cloth's mechanical energy comes from somewhere.
///
/// Kinetic energy, that of gravity and that of the springs together rise between two moments by no more than hand,
/// balls and wind have put in between them: gravity only turns one into another, and damping, drag and friction only
/// take. What the energy has risen by beyond that, since the moment for which it is the most, is the excess. It is the
/// method's own work, however much damping has taken before or takes meanwhile. A method that is well is allowed
/// - a twentieth of what lifting the cloth by its width and height takes, and
/// - a tenth of the energy in motion and springs, at the most since that moment: that of a symplectic method swings
///   about a mean that stays.
/// A cloth with an excess above both has gained energy from its integrator. Energy that a method takes is never
/// wrong here, for that is how implicit ones are stable.
///
/// The sums of every substep give the energy but for the springs'; those are summed, at the cost of a force evaluation,
/// every 0.1 s, and at once when the rest alone is too much already. So a few particles that fly apart show in the
/// substep in which their energy does, however many others there are.
class EnergyWatch {
public:
    /// Starts from the energy as it is: state or model have been changed from outside.
    void restart(const ClothModel& model, const Energy& energy);

    /// Counts what has been put in.
    /// @param work at least what it was; less than zero where that is taken back from what was given before [J]
    void give(double work) { base_ += work; }

    /// @param sums of the present state
    /// @param h substep that was made [s]
    /// @param min_pause substeps from one sum over the springs to the next, at least
    /// @return whether it is time to `measure`
    [[nodiscard]] bool look(const ClothModel& model, const MotionSums& sums, Real h, int min_pause);

    /// @param energy of the present state
    void measure(const Energy& energy);

    /// What it goes on from.
    void exchange(SnapshotText& text) { text.line("energy_watch", lift_, base_, peak_, excess_, waited_, substeps_); }

    /// What the energy has risen by that nothing put in, at the last sum over the springs [J].
    [[nodiscard]] double excess() const { return excess_; }

    /// Whether that is more than a method that is well would make.
    [[nodiscard]] bool gained() const;

    /// Work so small that a bound of it will do where measuring takes two sums over the springs [J].
    [[nodiscard]] double small_work() const;

private:
    double lift_ = 0;    ///< work that lifts the cloth by its size [J]
    double base_ = 0;    ///< energy at the moment that the excess counts from, and all that was given since [J]
    double peak_ = 0;    ///< most of motion and springs since that moment [J]
    double excess_ = 0;  ///< [J]
    double waited_ = 0;  ///< since the springs were last summed [s]
    int substeps_ = 0;   ///< since then
};

}  // namespace drape
