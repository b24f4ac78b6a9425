#include "drape/sim/energy_ledger.h"

#include <limits>

namespace drape {
namespace {

void add_change(const EnergyFlow& before, const EnergyFlow& after, Power& power) {
    power.damping += after.power.damping - before.power.damping;
    power.drag += after.power.drag - before.power.drag;
}

}  // namespace

EnergyBalance EnergyBalance::unknown() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none, none, none, none, none, none, none};
}

EnergyBalance& EnergyBalance::operator+=(const EnergyBalance& other) {
    wind += other.wind;
    hand += other.hand;
    pins += other.pins;
    ball += other.ball;
    damping += other.damping;
    drag += other.drag;
    contact += other.contact;
    held += other.held;
    integrator += other.integrator;
    return *this;
}

void EnergyLedger::see(const EnergyFlow& now) { see(now, now_); }

void EnergyLedger::see(const EnergyFlow& now, Entry& book) {
    const double change = now.energy.total() - book.seen.energy.total();
    if (book.since == Since::Hand) book.balance.hand += change - book.contact_energy;
    if (book.since == Since::Pins) book.balance.pins += change - book.contact_energy;
    if (book.since == Since::Step) {
        // Both ends of the step. For damping and drag the later one is before the contacts, for wind, hand and pins
        // after them: what contacts change in these two within a step goes to the integrator
        const double half = book.h / 2;
        const Power &first = book.seen.power, &last = now.power, &contact = book.contact_power;
        const double wind = half * (first.wind + last.wind), hand = half * (first.hand + last.hand);
        const double pins = half * (first.pins + last.pins);
        const double damping = half * (first.damping + last.damping - contact.damping);
        const double drag = half * (first.drag + last.drag - contact.drag);
        book.balance.wind += wind;
        book.balance.hand += hand;
        book.balance.pins += pins;
        book.balance.damping += damping;
        book.balance.drag += drag;
        book.balance.integrator += wind + hand + pins - damping - drag - (change - book.contact_energy);
    }
    book.seen = now;
    book.since = Since::Nothing;
    book.contact_energy = 0;
    book.contact_power = {};
}

void EnergyLedger::integrated(Real h) {
    now_.since = Since::Step;
    now_.h = static_cast<double>(h);
}

void EnergyLedger::pushed(double work) {
    now_.balance.contact -= work;
    now_.contact_energy += work;
}

void EnergyLedger::pushed_by_balls(double work) {
    now_.balance.ball += work;
    now_.balance.contact += work;
}

void EnergyLedger::responded(const EnergyFlow& before, const EnergyFlow& after, double ball_work) {
    const double change = after.energy.total() - before.energy.total();
    now_.balance.ball += ball_work;
    now_.balance.contact += ball_work - change;
    changed_after_step(before, after);
}

void EnergyLedger::held_back(const EnergyFlow& before, const EnergyFlow& after) {
    now_.balance.held += before.energy.total() - after.energy.total();
    changed_after_step(before, after);
}

void EnergyLedger::changed_after_step(const EnergyFlow& before, const EnergyFlow& after) {
    now_.contact_energy += after.energy.total() - before.energy.total();
    add_change(before, after, now_.contact_power);
}

EnergyBalance EnergyLedger::balance(const EnergyFlow& now) const {
    Entry book = now_;
    see(now, book);
    return book.balance;
}

}  // namespace drape
