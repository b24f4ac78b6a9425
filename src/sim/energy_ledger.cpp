#include "drape/sim/energy_ledger.h"

#include <array>
#include <limits>

namespace drape {
namespace {

constexpr std::array all_entries{&EnergyBalance::wind,    &EnergyBalance::hand,     &EnergyBalance::pins,
                                 &EnergyBalance::ball,    &EnergyBalance::damping,  &EnergyBalance::drag,
                                 &EnergyBalance::contact, &EnergyBalance::failsafe, &EnergyBalance::integrator};

}  // namespace

EnergyBalance EnergyBalance::unknown() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none, none, none, none, none, none, none};
}

EnergyBalance& EnergyBalance::operator+=(const EnergyBalance& other) {
    for (const auto entry : all_entries) this->*entry += other.*entry;
    return *this;
}

void EnergyLedger::see(const EnergyFlow& now) {
    const double change = now.energy.total() - seen_.energy.total();
    if (since_ == Since::Hand) balance_.hand += change - contact_energy_;
    if (since_ == Since::Pins) balance_.pins += change - contact_energy_;
    if (since_ == Since::Step) {
        // Both ends of the step. For damping and drag the later one is before the contacts, for wind, hand and pins
        // after them: what contacts change in these two within a step goes to the integrator
        const double half = h_ / 2;
        const Power &first = seen_.power, &last = now.power, &contact = contact_power_;
        const double wind = half * (first.wind + last.wind), hand = half * (first.hand + last.hand);
        const double pins = half * (first.pins + last.pins);
        const double damping = half * (first.damping + last.damping - contact.damping);
        const double drag = half * (first.drag + last.drag - contact.drag);
        balance_.wind += wind;
        balance_.hand += hand;
        balance_.pins += pins;
        balance_.damping += damping;
        balance_.drag += drag;
        balance_.integrator += wind + hand + pins - damping - drag - (change - contact_energy_);
    }
    seen_ = now;
    since_ = Since::Nothing;
    contact_energy_ = 0;
    contact_power_ = {};
}

void EnergyLedger::integrated(Real h) {
    since_ = Since::Step;
    h_ = static_cast<double>(h);
}

void EnergyLedger::pushed(double work) {
    balance_.contact -= work;
    contact_energy_ += work;
}

void EnergyLedger::responded(double EnergyBalance::*loss, const EnergyFlow& before, const EnergyFlow& after,
                             double ball_work) {
    const double change = after.energy.total() - before.energy.total();
    balance_.ball += ball_work;
    balance_.*loss += ball_work - change;
    contact_energy_ += change;
    contact_power_.damping += after.power.damping - before.power.damping;
    contact_power_.drag += after.power.drag - before.power.drag;
}

EnergyBalance EnergyLedger::balance(const EnergyFlow& now) const {
    EnergyLedger later = *this;
    later.see(now);
    return later.balance_;
}

}  // namespace drape
