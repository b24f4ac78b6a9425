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
    const double change = now.energy.total() - now_.seen.energy.total();
    if (now_.since == Since::Hand) now_.balance.hand += change - now_.contact_energy;
    if (now_.since == Since::Pins) now_.balance.pins += change - now_.contact_energy;
    if (now_.since == Since::Step) {
        // Both ends of the step. For damping and drag the later one is before the contacts, for wind, hand and pins
        // after them: what contacts change in these two within a step goes to the integrator
        const double half = now_.h / 2;
        const Power &first = now_.seen.power, &last = now.power, &contact = now_.contact_power;
        const double wind = half * (first.wind + last.wind), hand = half * (first.hand + last.hand);
        const double pins = half * (first.pins + last.pins);
        const double damping = half * (first.damping + last.damping - contact.damping);
        const double drag = half * (first.drag + last.drag - contact.drag);
        now_.balance.wind += wind;
        now_.balance.hand += hand;
        now_.balance.pins += pins;
        now_.balance.damping += damping;
        now_.balance.drag += drag;
        now_.balance.integrator += wind + hand + pins - damping - drag - (change - now_.contact_energy);
    }
    now_.seen = now;
    now_.since = Since::Nothing;
    now_.contact_energy = 0;
    now_.contact_power = {};
}

void EnergyLedger::integrated(Real h) {
    now_.since = Since::Step;
    now_.h = static_cast<double>(h);
}

void EnergyLedger::pushed(double work) {
    now_.balance.contact -= work;
    now_.contact_energy += work;
}

void EnergyLedger::responded(double EnergyBalance::*loss, const EnergyFlow& before, const EnergyFlow& after,
                             double ball_work) {
    const double change = after.energy.total() - before.energy.total();
    now_.balance.ball += ball_work;
    now_.balance.*loss += ball_work - change;
    now_.contact_energy += change;
    now_.contact_power.damping += after.power.damping - before.power.damping;
    now_.contact_power.drag += after.power.drag - before.power.drag;
}

EnergyBalance EnergyLedger::balance(const EnergyFlow& now) const {
    EnergyLedger later = *this;
    later.see(now);
    return later.now_.balance;
}

}  // namespace drape
