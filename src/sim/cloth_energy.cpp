#include "drape/sim/cloth_energy.h"

#include <algorithm>

namespace drape {
namespace {

/// The most energy that pushing contacts out puts into springs at rest [J]: each moves three particles by no more than
/// its push, and the springs of a particle answer with four of each kind, at both ends.
/// @param squared_push sum over the contacts [m^2]
double most_push_work(const ClothModel& model, Real squared_push) {
    const Real stiffness = 3 * 4 * (model.structural.stiffness + model.shear.stiffness + model.bend.stiffness);
    return static_cast<double>(stiffness) * static_cast<double>(squared_push);
}

}  // namespace

void ClothEnergy::keep_ledger(bool keep, const ClothModel& model, const ClothState& state) {
    if (keep == ledger_.has_value()) return;
    ledger_.reset();
    if (keep) ledger_.emplace(model, state);
}

void ClothEnergy::mark() {
    if (ledger_) ledger_->mark();
}

void ClothEnergy::return_to_mark() {
    if (ledger_) ledger_->return_to_mark();
}

void ClothEnergy::before_integrator(const ClothModel& model, const ClothState& state) {
    // Wind changes from substep to substep
    if (ledger_) ledger_->begin(model, state, touched_ || model.air.density > 0);
    touched_ = false;
}

void ClothEnergy::after_integrator(const ClothModel& model, const ClothState& state, const MotionSums& sums, Real h,
                                   int least_pause) {
    watch_.look(model, state, sums, h, least_pause);
    if (ledger_) ledger_->integrated(model, state, h);
}

/// What pushing stretches the springs by is the ball's work too. Mostly it is next to nothing, and a bound of it will
/// do.
ResponseReport ClothEnergy::respond(const ClothModel& model, const ResponseParameters& response,
                                    std::span<const Ball> balls, Real h, std::vector<Contact>& contacts,
                                    ClothState& state) {
    if (contacts.empty()) return {};
    double squared_push = 0;
    for (const Contact& found : contacts) {
        const auto push = static_cast<double>(push_of(found, balls[static_cast<std::size_t>(found.ball)].radius));
        if (push > 0) squared_push += push * push;
    }
    const double push_work = most_push_work(model, static_cast<Real>(squared_push));
    const bool measured = push_work > watch_.small_work();
    const double before = measured ? compute_energy(model, state).total() : 0;

    const ResponseReport left = resolve_contacts(model, response, balls, h, contacts, state);
    const double work = measured ? compute_energy(model, state).total() - before : left.ball_work + push_work;
    watch_.give(std::max(work, 0.0));
    if (ledger_) ledger_->responded(model, state, left.ball_work);
    return left;
}

void ClothEnergy::stilled(const ClothModel& model, const ClothState& state) {
    if (ledger_) ledger_->stilled(model, state);
}

}  // namespace drape
