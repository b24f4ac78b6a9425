#pragma once

#include <optional>
#include <span>

#include "drape/contact/response.h"
#include "drape/model/stretch_limit.h"
#include "drape/sim/energy_ledger.h"

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

/// What pushes one cloth.
struct Pushes {
    std::span<const ContactRow> rows;  ///< of all cloths
    int cloth;                         ///< the number of this one
    std::span<const Body> bodies;
    bool known = false;  ///< they are no more than what was found to be needed in the substep before
};

/// Where the energy of one cloth comes from and goes to, told event by event in the order of a substep: the watch that
/// every run has, and the ledger while one is kept.
class ClothEnergy {
public:
    /// Starts from the energy as it is, without a ledger.
    void restart(const ClothModel& model, const ClothState& state, Kernels kernels);

    /// Begins a ledger, or drops it.
    void keep_ledger(bool keep, const ClothModel& model, const ClothState& state);

    void use(Kernels kernels) { kernels_ = kernels; }

    /// State or model are about to be changed from outside, by the hand or by pins that move.
    /// @par Cost a force evaluation while a ledger is kept, the first time after a substep
    void touch(const ClothModel& model, const ClothState& state, EnergyLedger::Since by = EnergyLedger::Since::Hand);

    /// Pins of this cloth may move.
    void expect_pins(bool expected) { has_pins_ = expected; }

    /// Hand, pins, ball or wind have put in at least this [J].
    void give(double work) { watch_.give(work); }

    /// Remembers the entries so far; forgets those since.
    void mark() { marked_ = ledger_; }
    void return_to_mark() { ledger_ = marked_; }

    /// The integrator is about to step.
    /// @param grabbed particle that the hand leads; below 0: none
    /// @par Cost a force evaluation while a ledger is kept
    void start_of_step(const ClothModel& model, const ClothState& state, int grabbed);

    /// Enters what the integrator has done.
    /// @param min_pause substeps from one sum over the springs to the next, at least
    void after_integrator(const ClothModel& model, const ClothState& state, const MotionSums& sums, Real h,
                          int min_pause);

    /// Shortens what is stretched beyond the model's limit, which counts as the integrator's step.
    /// @param grabbed particle that the hand leads; below 0: none
    StretchReport limit_stretch(const ClothModel& model, int grabbed, ClothState& state);

    /// Contacts are about to push the cloth, or the fail-safe of contact between cloths to hold it back.
    void before_pushes(const ClothModel& model, const ClothState& state, const Pushes& pushes);
    void before_hold(const ClothModel& model, const ClothState& state);

    /// They have, and that is entered.
    /// @param ball_work by balls on the cloth [J]
    void after_pushes(const ClothModel& model, const ClothState& state, double ball_work = 0);

    /// In the end of a substep: the work of known pushes, as forces along all of its motion [J].
    void pushed(double work) {
        if (ledger_) ledger_->pushed(work);
    }

    /// Velocities are about to be set to zero by sleep.
    void still(const ClothModel& model, const ClothState& state);

    /// What the next step goes on from.
    /// @param grabbed particle that the hand leads
    void exchange(SnapshotText& text, int grabbed) {
        grabbed_ = grabbed;
        watch_.exchange(text);
        if (ledger_) ledger_->exchange(text);
    }

    [[nodiscard]] const EnergyWatch& watch() const { return watch_; }

    /// The energy of the present state.
    /// @param balance receives what has happened since the ledger began, which is unknown without one
    [[nodiscard]] Energy energy(const ClothModel& model, const ClothState& state, EnergyBalance& balance);

private:
    EnergyFlow flow(const ClothModel& model, const ClothState& state);
    [[nodiscard]] EnergyFlow pushed_flow(const ClothModel& model, const ClothState& state) const;

    Kernels kernels_ = Kernels::Plain;
    EnergyWatch watch_;
    std::optional<EnergyLedger> ledger_, marked_;
    bool has_pins_ = false;
    int grabbed_ = -1;                       ///< particle that the hand leads
    bool pushed_ = false;                    ///< by the contacts or the fail-safe at hand
    EnergyFlow before_;                      ///< of what contacts or the fail-safe are about to push
    double EnergyBalance::*loss_ = nullptr;  ///< the entry for what this dissipates
    bool known_ = false;
    double max_push_work_ = 0;  ///< a bound [J]
    Points wind_;               ///< scratch, while a ledger is kept
};

}  // namespace drape
