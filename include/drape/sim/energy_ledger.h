#pragma once

#include "drape/model/energy.h"

namespace drape {

/// What has come to a cloth's mechanical energy and gone from it [J]: it has changed by
/// wind + hand + ball - damping - drag - contact - integrator.
struct EnergyBalance {
    double wind = 0;        ///< given by the wind
    double hand = 0;        ///< given by whoever drags the cloth, or changes what it is made of
    double ball = 0;        ///< given by the balls' motion, through the impulses of their contacts
    double damping = 0;     ///< dissipated in the springs' damping
    double drag = 0;        ///< dissipated in the air
    double contact = 0;     ///< dissipated in contacts; less than zero where pushing the cloth out has stretched it
    double integrator = 0;  ///< dissipated by the method itself, and nowhere in nature: the rest

    /// Of a cloth without a ledger: no entry is a number.
    static EnergyBalance unknown();

    EnergyBalance& operator+=(const EnergyBalance& other);

    /// What the energy has changed by.
    [[nodiscard]] double change() const { return wind + hand + ball - damping - drag - contact - integrator; }
};

/// Keeps the balance of one cloth, entry by entry, in the order of a step: `begin`, `integrated`, `responded`.
/// Damping, drag, wind and hand are integrated by the trapezoidal rule from both ends of the integrator's step, so that
/// what a step is too long for counts as the integrator's.
class EnergyLedger {
public:
    EnergyLedger(const ClothModel& model, const ClothState& state) : scratch_(state.x.rows(), 3) { look(model, state); }

    /// @param touched whether state or model may differ from what the last entry saw: the difference is the hand's
    /// @par Cost O(particles) if touched
    void begin(const ClothModel& model, const ClothState& state, bool touched);

    /// @param h step that the integrator has made [s]
    /// @par Cost O(particles), about that of a force evaluation or two
    void integrated(const ClothModel& model, const ClothState& state, Real h);

    /// @param ball_work as the response reports it [J]
    /// @par Cost O(particles)
    void responded(const ClothModel& model, const ClothState& state, double ball_work);

    /// What has happened to the state since the last entry is the integrator's: velocities were set to zero by sleep.
    void stilled(const ClothModel& model, const ClothState& state);

    /// Since the ledger began.
    [[nodiscard]] const EnergyBalance& balance() const { return now_.balance; }

    /// Remembers the entries so far, and forgets those since.
    void mark() { marked_ = now_; }
    void return_to_mark() { now_ = marked_; }

private:
    void look(const ClothModel& model, const ClothState& state);

    struct Book {
        EnergyBalance balance;
        double energy = 0;  ///< after the last entry, as the power
        Power power;
    };

    Book now_, marked_;
    Points scratch_;
};

}  // namespace drape
