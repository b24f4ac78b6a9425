#include "drape/sim/energy_watch.h"

#include <algorithm>

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

}  // namespace

MotionSums sum_motion(const ClothState& state) {
    return {state.x.colwise().sum().transpose(), state.v.colwise().sum().transpose(), state.v.squaredNorm()};
}

void EnergyWatch::restart(const ClothModel& model, const Energy& energy) {
    const Grid& grid = model.grid;
    const Real size = model.hx * static_cast<Real>(grid.nx - 1) + model.hy * static_cast<Real>(grid.ny - 1);
    const Real weight = model.particle_mass * static_cast<Real>(grid.particles()) * gravity_scale(model);
    lift_ = static_cast<double>(weight * size);
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

}  // namespace drape
