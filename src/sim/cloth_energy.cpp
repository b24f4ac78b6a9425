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

/// The smallest range that holds all corners of the contacts.
GridRange range_of(std::span<const Contact> contacts, const Grid& grid) {
    GridRange range{grid.nx, 0, grid.ny, 0};
    for (const Contact& contact : contacts) {
        for (const int corner : contact.corners) {
            const int i = corner % grid.nx, j = corner / grid.nx;
            range.first_column = std::min(range.first_column, i);
            range.end_column = std::max(range.end_column, i + 1);
            range.first_row = std::min(range.first_row, j);
            range.end_row = std::max(range.end_row, j + 1);
        }
    }
    return range;
}

/// What the contacts push the springs by, at the most [J].
double most_push_work(const ClothModel& model, std::span<const Ball> balls, std::span<const Contact> contacts) {
    double squared_push = 0;
    for (const Contact& found : contacts) {
        const auto push = static_cast<double>(push_of(found, balls));
        if (push > 0) squared_push += push * push;
    }
    return most_push_work(model, static_cast<Real>(squared_push));
}

}  // namespace

void ClothEnergy::restart(const ClothModel& model, const ClothState& state, Kernels kernels) {
    use(kernels);
    watch_.restart(model, compute_energy(model, state, kernels));
}

EnergyFlow ClothEnergy::flow(const ClothModel& model, const ClothState& state) {
    return compute_energy_flow(model, state.x, state.v, wind_, kernels_);
}

void ClothEnergy::keep_ledger(bool keep, const ClothModel& model, const ClothState& state) {
    if (keep == ledger_.has_value()) return;
    ledger_.reset();
    if (!keep) return;
    wind_.resize(state.x.rows(), 3);
    ledger_.emplace(flow(model, state));
}

void ClothEnergy::touch(const ClothModel& model, const ClothState& state) {
    if (!ledger_) return;
    if (ledger_->must_see()) ledger_->see(flow(model, state));
    ledger_->touched();
}

void ClothEnergy::mark() {
    if (ledger_) ledger_->mark();
}

void ClothEnergy::return_to_mark() {
    if (ledger_) ledger_->return_to_mark();
}

void ClothEnergy::after_integrator(const ClothModel& model, const ClothState& state, const MotionSums& sums, Real h,
                                   int least_pause) {
    if (watch_.look(model, sums, h, least_pause)) watch_.measure(compute_energy(model, state, kernels_));
    if (!ledger_) return;
    ledger_->see(start_);
    ledger_->integrated(h);
}

/// The springs that are shortened hand on what hand and balls have pulled and pushed: what that adds to the energy is
/// their work too. The ledger sees the limit as part of the step.
StretchReport ClothEnergy::limit_stretch(const ClothModel& model, int held, ClothState& state) {
    const StretchReport unlimited{.excess = stretch_excess(model, state.x)};
    if (unlimited.excess <= stretch_tolerance) return unlimited;
    const double before = compute_energy(model, state, kernels_).total();
    const StretchReport report = drape::limit_stretch(model, held, state);
    watch_.give(std::max(compute_energy(model, state, kernels_).total() - before, 0.0));
    return report;
}

/// What pushing stretches the springs by is the ball's work too. Mostly it is next to nothing, and a bound of it will
/// do.
ResponseReport ClothEnergy::respond(const ResponseParameters& response, Real h, ClothInContact cloth,
                                    std::span<Ball> balls, std::span<BallContact> ball_contacts) {
    if (cloth.contacts.empty()) return resolve_contacts(response, h, cloth, balls, ball_contacts);
    const double push_work = most_push_work(cloth.model, balls, cloth.contacts);
    const bool measured = ledger_ || push_work > watch_.small_work();
    const GridRange range = range_of(cloth.contacts, cloth.model.grid);
    const auto look = [&] {
        return measured ? compute_energy_around(cloth.model, cloth.state.x, cloth.state.v, range, kernels_)
                        : EnergyFlow{};
    };
    const EnergyFlow before = look();
    const ResponseReport left = resolve_contacts(response, h, cloth, balls, ball_contacts);
    const EnergyFlow after = look();
    const double work = after.energy.total() - before.energy.total();
    watch_.give(std::max(push_work > watch_.small_work() ? work : left.ball_work + push_work, 0.0));
    if (ledger_) ledger_->responded(before, after, left.ball_work);
    return left;
}

void ClothEnergy::before_step(const ClothModel& model, std::span<Ball> balls, ClothState& state,
                              const WarmStart& start) {
    warm_start(model, balls, state, start, &WarmStart::before_step);
}

void ClothEnergy::after_step(const ClothModel& model, std::span<Ball> balls, ClothState& state,
                             const WarmStart& start) {
    warm_start(model, balls, state, start, &WarmStart::after_step);
}

void ClothEnergy::warm_start(const ClothModel& model, std::span<Ball> balls, ClothState& state, const WarmStart& start,
                             Give pushes) {
    if (start.pushes().empty()) return;
    const double balls_before = kinetic_energy(balls);
    const GridRange range = range_of(start.pushes(), model.grid);
    const auto look = [&] {
        return ledger_ ? compute_energy_around(model, state.x, state.v, range, kernels_) : EnergyFlow{};
    };
    const EnergyFlow before = look();
    (start.*pushes)(model, balls, state);
    const double ball_work = balls_before - kinetic_energy(balls);
    watch_.give(std::max(ball_work, 0.0));
    if (ledger_) ledger_->responded(before, look(), ball_work);
}

void ClothEnergy::still(const ClothModel& model, const ClothState& state) {
    if (!ledger_) return;
    ledger_->see(flow(model, state));
    ledger_->integrated(0);
}

Energy ClothEnergy::energy(const ClothModel& model, const ClothState& state, EnergyBalance& balance) {
    balance = EnergyBalance::unknown();
    if (!ledger_) return compute_energy(model, state, kernels_);
    const EnergyFlow now = flow(model, state);
    balance = ledger_->balance(now);
    return now.energy;
}

}  // namespace drape
