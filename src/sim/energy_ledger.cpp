#include "drape/sim/energy_ledger.h"

#include <limits>

namespace drape {

EnergyBalance EnergyBalance::unknown() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none, none, none, none, none};
}

EnergyBalance& EnergyBalance::operator+=(const EnergyBalance& other) {
    wind += other.wind;
    hand += other.hand;
    ball += other.ball;
    damping += other.damping;
    drag += other.drag;
    contact += other.contact;
    integrator += other.integrator;
    return *this;
}

void EnergyLedger::look(const ClothModel& model, const ClothState& state) {
    const EnergyFlow flow = compute_energy_flow(model, state, scratch_);
    now_.energy = flow.energy.total();
    now_.power = flow.power;
}

void EnergyLedger::begin(const ClothModel& model, const ClothState& state, bool touched) {
    if (!touched) return;
    const double before = now_.energy;
    look(model, state);
    now_.balance.hand += now_.energy - before;
}

void EnergyLedger::integrated(const ClothModel& model, const ClothState& state, Real h) {
    const double before = now_.energy, half = static_cast<double>(h) / 2;
    const Power first = now_.power;
    look(model, state);
    const double wind = half * (first.wind + now_.power.wind), hand = half * (first.hand + now_.power.hand);
    const double damping = half * (first.damping + now_.power.damping), drag = half * (first.drag + now_.power.drag);
    now_.balance.wind += wind;
    now_.balance.hand += hand;
    now_.balance.damping += damping;
    now_.balance.drag += drag;
    now_.balance.integrator += before - now_.energy + wind + hand - damping - drag;
}

void EnergyLedger::responded(const ClothModel& model, const ClothState& state, double ball_work) {
    const double before = now_.energy;
    look(model, state);
    now_.balance.ball += ball_work;
    now_.balance.contact += before - now_.energy + ball_work;
}

void EnergyLedger::stilled(const ClothModel& model, const ClothState& state) {
    const double before = now_.energy;
    look(model, state);
    now_.balance.integrator += before - now_.energy;
}

}  // namespace drape
