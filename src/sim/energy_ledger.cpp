#include "drape/sim/energy_ledger.h"

namespace drape {

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
    energy_ = flow.energy.total();
    power_ = flow.power;
}

void EnergyLedger::begin(const ClothModel& model, const ClothState& state, bool touched) {
    if (!touched) return;
    const double before = energy_;
    look(model, state);
    balance_.hand += energy_ - before;
}

void EnergyLedger::integrated(const ClothModel& model, const ClothState& state, Real h) {
    const double before = energy_, half = static_cast<double>(h) / 2;
    const Power first = power_;
    look(model, state);
    const double wind = half * (first.wind + power_.wind), hand = half * (first.hand + power_.hand);
    const double damping = half * (first.damping + power_.damping), drag = half * (first.drag + power_.drag);
    balance_.wind += wind;
    balance_.hand += hand;
    balance_.damping += damping;
    balance_.drag += drag;
    balance_.integrator += before - energy_ + wind + hand - damping - drag;
}

void EnergyLedger::responded(const ClothModel& model, const ClothState& state, double ball_work) {
    const double before = energy_;
    look(model, state);
    balance_.ball += ball_work;
    balance_.contact += before - energy_ + ball_work;
}

void EnergyLedger::stilled(const ClothModel& model, const ClothState& state) {
    const double before = energy_;
    look(model, state);
    balance_.integrator += before - energy_;
}

}  // namespace drape
