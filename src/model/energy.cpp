#include "drape/model/energy.h"

#include <algorithm>

#include "drape/model/forces.h"
#include "drape/model/stencils.h"
#include "kernels/energy_kernels.h"
#include "kernels/wind_kernels.h"

namespace drape {
namespace {

double square(double a) { return a * a; }

double dot(const Points& f, const Points& v, Eigen::Index particle) {
    return static_cast<double>(f.row(particle).dot(v.row(particle)));
}

SpringSums sum_over_springs(const SpringStencil& springs, const Grid& grid, const Points& x, const Points& v) {
    SpringSums sums;
    springs.for_each(grid, [&](int a, int b) {
        const Vec3 d = x.row(a) - x.row(b), w = v.row(a) - v.row(b);
        const auto length = static_cast<double>(d.norm());
        sums.squared_elongations += square(length - static_cast<double>(springs.rest_length));
        if (length > 0) sums.squared_closing_speeds += square(static_cast<double>(d.dot(w)) / length);
    });
    return sums;
}

/// @param power whose loss in springs and air is set on the way
Energy compute_energy(const ClothModel& model, const ClothState& state, Kernels kernels, Power& power) {
    const bool plain = kernels == Kernels::Plain;
    const auto mass = static_cast<double>(model.particle_mass);
    const double squared_speeds = plain ? state.v.cast<double>().squaredNorm() : kernels::sum_of_squares(state.v);
    Energy energy;
    energy.kinetic = mass / 2 * squared_speeds;
    power.drag = static_cast<double>(model.drag) * squared_speeds;
    for (int axis = 0; axis < 3; ++axis) {
        const auto g = static_cast<double>(model.gravity[axis]);
        if (g != 0) energy.gravity -= mass * g * state.x.col(axis).cast<double>().sum();
    }
    for (const SpringStencil& springs : spring_stencils(model)) {
        if (springs.law == SpringLaw{}) continue;
        const SpringSums sums =
            (plain ? sum_over_springs : kernels::sum_over_springs)(springs, model.grid, state.x, state.v);
        energy.spring += static_cast<double>(springs.law.stiffness) / 2 * sums.squared_elongations;
        power.damping += static_cast<double>(springs.law.damping) * sums.squared_closing_speeds;
    }
    return energy;
}

}  // namespace

Energy compute_energy(const ClothModel& model, const ClothState& state, Kernels kernels) {
    Power power;
    return compute_energy(model, state, kernels, power);
}

EnergyFlow compute_energy_flow(const ClothModel& model, const ClothState& state, Points& wind, Kernels kernels) {
    EnergyFlow flow;
    Power& power = flow.power;
    flow.energy = compute_energy(model, state, kernels, power);
    const bool windy = model.air.density > 0;
    if (windy) {
        wind.setZero();
        (kernels == Kernels::Plain ? add_wind_forces : kernels::add_wind_forces)(model, state.x, state.v, wind);
        for (Eigen::Index p = 0; p < wind.rows(); ++p) power.wind += dot(wind, state.v, p);
    }
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (!model.pinned(p) || state.v.row(p).isZero(0)) continue;
        power.hand -= static_cast<double>(force_on(model, state, p).dot(state.v.row(p)));
        if (windy) power.hand -= dot(wind, state.v, p);
    }
    return flow;
}

double most_wind_power(const ClothModel& model) {
    constexpr double stretched = 2;
    const auto speed = static_cast<double>(model.air.velocity.norm());
    const Grid& grid = model.grid;
    const auto area = static_cast<double>(model.hx * model.hy) * (grid.nx - 1) * (grid.ny - 1);
    const auto pressure = static_cast<double>(plate_coefficient * model.air.density) / 2;  // divided by W^2
    return stretched * pressure * area * speed * speed * speed * 4 / 27;
}

Real largest_stretch(const ClothModel& model, const Points& x) {
    Real largest = -1;
    const auto stencils = spring_stencils(model);
    for (const SpringStencil& springs : {stencils[0], stencils[1]}) {
        springs.for_each(model.grid, [&](int a, int b) {
            largest = std::max(largest, (x.row(a) - x.row(b)).norm() / springs.rest_length - 1);
        });
    }
    return largest;
}

}  // namespace drape
