#pragma once

#include "drape/base/snapshot_text.h"
#include "drape/model/energy.h"

namespace drape {

/// What has come to a cloth's mechanical energy and gone from it [J], see `change`.
struct EnergyBalance {
    double wind = 0;        ///< given by the wind
    double hand = 0;        ///< given by whoever drags the cloth, or changes what it is made of
    double pins = 0;        ///< given by pins that move
    double ball = 0;        ///< given by the balls' motion, through the impulses of their contacts
    double damping = 0;     ///< dissipated in the springs' damping
    double drag = 0;        ///< dissipated in the air
    double contact = 0;     ///< dissipated in contacts; less than zero where pushing the cloth out has stretched it
    double failsafe = 0;    ///< taken by the fail-safe of contact between cloths
    double integrator = 0;  ///< dissipated by the method itself and the stretch limit, and nowhere in nature: the rest

    /// Of a cloth without a ledger: no entry is a number.
    static EnergyBalance unknown();

    EnergyBalance& operator+=(const EnergyBalance& other);

    /// What the energy has changed by.
    [[nodiscard]] double change() const {
        return wind + hand + pins + ball - damping - drag - contact - failsafe - integrator;
    }
};

/// Keeps the balance of one cloth. It is told what happens to the cloth, and now and then sees the energy: what that
/// has changed by since it was last seen belongs to what has happened in between. The end of a step is seen at the
/// start of the next.
///
/// Damping, drag, wind, hand and pins are integrated by the trapezoidal rule from both ends of the integrator's step,
/// so that what a step is too long for counts as the integrator's.
class EnergyLedger {
public:
    /// What has happened since the energy was last seen: nothing, a step, or a change by the hand or the pins.
    enum class Since { Nothing, Step, Hand, Pins };

    explicit EnergyLedger(const EnergyFlow& now) : seen_(now) {}

    /// @param now energy of the present state, and its flow
    void see(const EnergyFlow& now);

    /// The integrator has made a step [s] from the state that was seen last.
    void integrated(Real h);

    /// Contacts have given their pushes of the substep before. They count as steady forces along all of the substep's
    /// motion: at rest these do no work, though the step lets the cloth fall and the pushes lift it again.
    /// @param work by them [J]
    void pushed(double work);

    /// Contacts were answered, or the fail-safe has held the cloth back.
    /// @param loss the entry for what that dissipates
    /// @param before,after of the part of the cloth that this may have moved; both the same if it gives what `pushed`
    /// is told of
    /// @param ball_work by balls [J]
    void responded(double EnergyBalance::*loss, const EnergyFlow& before, const EnergyFlow& after, double ball_work);

    /// State or model are about to be changed from outside, which is the work of the hand or of pins.
    /// @pre the present energy has been seen, or the same was said before
    void touched(Since by) { since_ = by; }

    /// Whether the energy must be seen before a change from outside.
    [[nodiscard]] bool must_see(Since by) const { return since_ != Since::Nothing && since_ != by; }

    /// Since the ledger began.
    /// @param now as for `see`
    [[nodiscard]] EnergyBalance balance(const EnergyFlow& now) const;

    /// What it goes on from.
    void exchange(SnapshotText& text);

private:
    EnergyBalance balance_;
    EnergyFlow seen_;
    Since since_ = Since::Nothing;  ///< what has happened since then
    double h_ = 0;                  ///< of the step [s]
    double contact_energy_ = 0;     ///< by which contacts and fail-safe have changed the energy since the step [J]
    Power contact_power_;           ///< and the power
};

}  // namespace drape
