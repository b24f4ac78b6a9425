#include "drape/sim/energy_watch.h"

#include <algorithm>
#include <cmath>

#include "drape/model/energy.h"
#include "drape/model/stencils.h"

namespace drape {
namespace {

/// Of the work that lifts the cloth by its size, and of the energy in motion and springs, what a method that is well
/// may make. Shipped scenes show no excess at all.
constexpr double lifts = 0.05, part = 0.1;

/// Of the work that lifts the cloth: what a resting contact pushes by is less, so that few steps measure.
constexpr double small = 1e-3;

/// From one sum over the springs to the next [s].
constexpr double pause = 0.1;

double allowed(double lift, double in_motion) { return lifts * lift + part * in_motion; }

}  // namespace

MotionSums sum_motion(const ClothState& state) {
    return {state.x.colwise().sum().transpose(), state.v.colwise().sum().transpose(), state.v.squaredNorm()};
}

void EnergyWatch::restart(const ClothModel& model, const ClothState& state) {
    const Grid& grid = model.grid;
    const Real size = model.hx * static_cast<Real>(grid.nx - 1) + model.hy * static_cast<Real>(grid.ny - 1);
    const Real weight = model.particle_mass * static_cast<Real>(grid.particles()) * model.gravity.norm();
    lift_ = static_cast<double>(weight * size);
    const Energy energy = compute_energy(model, state);
    base_ = energy.total();
    peak_ = energy.kinetic + energy.spring;
    excess_ = waited_ = 0;
    substeps_ = 0;
}

void EnergyWatch::look(const ClothModel& model, const ClothState& state, const MotionSums& sums, Real h,
                       int least_pause) {
    waited_ += static_cast<double>(h);
    ++substeps_;
    const auto mass = static_cast<double>(model.particle_mass);
    const double kinetic = mass / 2 * static_cast<double>(sums.squared_speeds);
    const double gravity = -mass * static_cast<double>(model.gravity.dot(sums.positions));
    const bool due = waited_ >= pause && substeps_ >= least_pause;
    const bool too_much = kinetic + gravity - base_ > allowed(lift_, std::max(peak_, kinetic));
    if (due || too_much) measure(model, state);
}

void EnergyWatch::measure(const ClothModel& model, const ClothState& state) {
    waited_ = 0;
    substeps_ = 0;
    const Energy energy = compute_energy(model, state);
    const double in_motion = energy.kinetic + energy.spring;
    excess_ = energy.total() - base_;
    peak_ = std::max(peak_, in_motion);
    if (excess_ > 0) return;
    excess_ = 0;
    base_ = energy.total();
    peak_ = in_motion;
}

bool EnergyWatch::heated() const { return excess_ > allowed(lift_, peak_); }

double EnergyWatch::small_work() const { return small * lift_; }

double hand_power(const ClothModel& model, const ClothState& state, int particle) {
    const Grid& grid = model.grid;
    const int i = particle % grid.nx, j = particle / grid.nx;
    const Vec3 x = state.x.row(particle).transpose(), v = state.v.row(particle).transpose();
    Vec3 force = model.particle_mass * model.gravity - model.drag * v;
    for (const SpringStencil& springs : spring_stencils(model)) {
        for (const int side : {-1, 1}) {
            const int other_i = i + side * springs.di, other_j = j + side * springs.dj;
            if (other_i < 0 || other_i >= grid.nx || other_j < 0 || other_j >= grid.ny) continue;
            const int other = grid.particle(other_i, other_j);
            const Vec3 d = x - state.x.row(other).transpose(), u = v - state.v.row(other).transpose();
            const Real length = d.norm();
            if (length == 0) continue;
            const Vec3 n = d / length;
            force -= (springs.law.stiffness * (length - springs.rest_length) + springs.law.damping * n.dot(u)) * n;
        }
    }
    return static_cast<double>(-force.dot(v));
}

double most_push_work(const ClothModel& model, Real squared_push) {
    const Real stiffness = 3 * 4 * (model.structural.stiffness + model.shear.stiffness + model.bend.stiffness);
    return static_cast<double>(stiffness) * static_cast<double>(squared_push);
}

}  // namespace drape
