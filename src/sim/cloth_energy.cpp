#include "drape/sim/cloth_energy.h"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

/// Of the work that lifts the cloth by its size, and of the energy in motion and springs, what a method that is well
/// may make. Shipped scenes show no excess at all.
constexpr double of_lift = 0.05, of_motion = 0.1;

/// Of the work that lifts the cloth: what a resting contact pushes by is less, so that few steps measure.
constexpr double small = 1e-3;

/// From one sum over the springs to the next [s].
constexpr double pause = 0.1;

double allowed(double lift, double in_motion) { return of_lift * lift + of_motion * in_motion; }

/// Whether a contact pushes a cloth.
bool moves(const ContactRow& row, int cloth) {
    return std::ranges::any_of(row.moved(), [&](const RowParticle& p) { return p.cloth == cloth; });
}

/// The most energy that pushing contacts out puts into springs at rest [J]: each moves three particles by no more than
/// its push, and the springs of a particle answer with four of each kind, at both ends. What another cloth gives, or
/// another part of this one, no bound tells.
double max_push_work(const ClothModel& model, const Pushes& pushes) {
    double squared_push = 0;
    for (const ContactRow& row : pushes.rows) {
        if (!moves(row, pushes.cloth)) continue;
        if (row.kind == RowKind::Pair) return std::numeric_limits<double>::infinity();
        if (pushes.known) continue;
        const double push = std::max(static_cast<double>(correction_of(row, pushes.bodies)), 0.0);
        squared_push += push * push;
    }
    const Real stiffness = 3 * 4 * (model.structural.stiffness + model.shear.stiffness + model.bend.stiffness);
    return static_cast<double>(stiffness) * squared_push;
}

}  // namespace

MotionSums sum_motion(const ClothState& state) {
    return {state.x.colwise().sum().transpose(), state.v.colwise().sum().transpose(), state.v.squaredNorm()};
}

void EnergyWatch::restart(const ClothModel& model, const Energy& energy) {
    const Real weight = model.particle_mass * static_cast<Real>(model.grid.particles()) * gravity_scale(model);
    lift_ = static_cast<double>(weight * (model.width() + model.height()));
    base_ = energy.total();
    peak_ = energy.kinetic + energy.spring;
    excess_ = waited_ = 0;
    substeps_ = 0;
}

bool EnergyWatch::look(const ClothModel& model, const MotionSums& sums, Real h, int min_pause) {
    waited_ += static_cast<double>(h);
    ++substeps_;
    const auto mass = static_cast<double>(model.particle_mass);
    const double kinetic = mass / 2 * static_cast<double>(sums.squared_speeds);
    const double gravity = -mass * static_cast<double>(model.gravity.dot(sums.positions));
    const bool due = waited_ >= pause && substeps_ >= min_pause;
    const bool too_much = kinetic + gravity - base_ > allowed(lift_, std::max(peak_, kinetic));
    return due || too_much;
}

void EnergyWatch::measure(const Energy& energy) {
    waited_ = 0;
    substeps_ = 0;
    const double in_motion = energy.kinetic + energy.spring;
    excess_ = energy.total() - base_;
    peak_ = std::max(peak_, in_motion);
    if (excess_ > 0) return;
    excess_ = 0;
    base_ = energy.total();
    peak_ = in_motion;
}

bool EnergyWatch::gained() const { return excess_ > allowed(lift_, peak_); }

double EnergyWatch::small_work() const { return small * lift_; }

void ClothEnergy::restart(const ClothModel& model, const ClothState& state, Kernels kernels) {
    use(kernels);
    watch_.restart(model, compute_energy(model, state, kernels));
}

/// What all held particles are given, but for the hand's, is the pins'.
EnergyFlow ClothEnergy::flow(const ClothModel& model, const ClothState& state) {
    EnergyFlow flow = compute_energy_flow(model, state.x, state.v, wind_, kernels_);
    if (!has_pins_) return flow;
    const double of_hand = grabbed_ >= 0 ? held_power(model, state.x, state.v, grabbed_) : 0;
    flow.power.pins = flow.power.hand - of_hand;
    flow.power.hand = of_hand;
    return flow;
}

void ClothEnergy::start_of_step(const ClothModel& model, const ClothState& state, int grabbed) {
    if (!ledger_) return;
    grabbed_ = grabbed;
    ledger_->see(flow(model, state));
}

void ClothEnergy::keep_ledger(bool keep, const ClothModel& model, const ClothState& state) {
    if (keep == ledger_.has_value()) return;
    ledger_.reset();
    if (!keep) return;
    wind_.resize(state.x.rows(), 3);
    ledger_.emplace(flow(model, state));
}

void ClothEnergy::touch(const ClothModel& model, const ClothState& state, EnergyLedger::Since by) {
    if (!ledger_) return;
    if (ledger_->must_see(by)) ledger_->see(flow(model, state));
    ledger_->touched(by);
}

void ClothEnergy::after_integrator(const ClothModel& model, const ClothState& state, const MotionSums& sums, Real h,
                                   int min_pause) {
    if (watch_.look(model, sums, h, min_pause)) watch_.measure(compute_energy(model, state, kernels_));
    if (ledger_) ledger_->integrated(h);
}

/// The springs that are shortened hand on what hand and balls have pulled and pushed: what that adds to the energy is
/// their work too. The ledger sees the limit as part of the step.
StretchReport ClothEnergy::limit_stretch(const ClothModel& model, int grabbed, ClothState& state) {
    const StretchReport unlimited{.excess = stretch_excess(model, state.x)};
    if (unlimited.excess <= stretch_tolerance) return unlimited;
    const double before = compute_energy(model, state, kernels_).total();
    const StretchReport report = drape::limit_stretch(model, grabbed, state);
    watch_.give(std::max(compute_energy(model, state, kernels_).total() - before, 0.0));
    return report;
}

/// What pushing stretches the springs by is work too. Mostly it is next to nothing, and a bound of it will do.
void ClothEnergy::before_pushes(const ClothModel& model, const ClothState& state, const Pushes& pushes) {
    pushed_ = std::ranges::any_of(pushes.rows, [&](const ContactRow& row) { return moves(row, pushes.cloth); });
    loss_ = &EnergyBalance::contact;
    known_ = pushes.known;
    max_push_work_ = max_push_work(model, pushes);
    before_ = pushed_flow(model, state);
}

void ClothEnergy::before_hold(const ClothModel& model, const ClothState& state) {
    pushed_ = true;
    loss_ = &EnergyBalance::failsafe;
    known_ = false;
    max_push_work_ = std::numeric_limits<double>::infinity();
    before_ = pushed_flow(model, state);
}

void ClothEnergy::after_pushes(const ClothModel& model, const ClothState& state, double ball_work) {
    if (!pushed_) return;
    const EnergyFlow after = pushed_flow(model, state);
    const double work = after.energy.total() - before_.energy.total();
    const bool measured = max_push_work_ > watch_.small_work();
    watch_.give(std::max(measured ? work : ball_work + max_push_work_, 0.0));
    if (ledger_) ledger_->responded(loss_, known_ ? after : before_, after, ball_work);
}

/// Where it is to be measured what pushes do.
EnergyFlow ClothEnergy::pushed_flow(const ClothModel& model, const ClothState& state) const {
    const bool measured = ledger_ || max_push_work_ > watch_.small_work();
    return measured && pushed_ ? compute_dissipation(model, state.x, state.v, kernels_) : EnergyFlow();
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
