#include "drape/model/energy.h"

#include "drape/model/forces.h"
#include "drape/model/stencils.h"
#include "kernels/energy_kernels.h"
#include "kernels/force_kernels.h"

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

ParticleSums sum_over_particles(const Grid& grid, const Points& x, const Points& v) {
    ParticleSums sums;
    for (int p = 0; p < grid.particles(); ++p) {
        sums.positions += x.row(p).cast<double>().transpose();
        sums.squared_speeds += v.row(p).cast<double>().squaredNorm();
    }
    return sums;
}

}  // namespace

EnergyFlow compute_dissipation(const ClothModel& model, const Points& x, const Points& v, Kernels kernels) {
    const bool plain = kernels == Kernels::Plain;
    const auto mass = static_cast<double>(model.particle_mass);
    const ParticleSums particles = (plain ? sum_over_particles : kernels::sum_over_particles)(model.grid, x, v);
    EnergyFlow flow;
    flow.energy.kinetic = mass / 2 * particles.squared_speeds;
    flow.energy.gravity = -mass * model.gravity.cast<double>().dot(particles.positions);
    flow.power.drag = static_cast<double>(model.drag) * particles.squared_speeds;
    for (const SpringStencil& springs : spring_stencils(model)) {
        if (springs.law == SpringLaw{}) continue;
        const SpringSums sums = (plain ? sum_over_springs : kernels::sum_over_springs)(springs, model.grid, x, v);
        flow.energy.spring += static_cast<double>(springs.law.stiffness) / 2 * sums.squared_elongations;
        flow.power.damping += static_cast<double>(springs.law.damping) * sums.squared_closing_speeds;
    }
    return flow;
}

Energy compute_energy(const ClothModel& model, const ClothState& state, Kernels kernels) {
    return compute_dissipation(model, state.x, state.v, kernels).energy;
}

EnergyFlow compute_energy_flow(const ClothModel& model, const Points& x, const Points& v, Points& wind,
                               Kernels kernels) {
    EnergyFlow flow = compute_dissipation(model, x, v, kernels);
    Power& power = flow.power;
    const bool windy = model.air.density > 0;
    if (windy) {
        wind.setZero();
        (kernels == Kernels::Plain ? add_wind_forces : kernels::add_wind_forces)(model, x, v, wind);
        for (Eigen::Index p = 0; p < wind.rows(); ++p) power.wind += dot(wind, v, p);
    }
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (!model.pinned(p) || v.row(p).isZero(0)) continue;
        power.hand += held_power(model, x, v, p);
        if (windy) power.hand -= dot(wind, v, p);
    }
    return flow;
}

double held_power(const ClothModel& model, const Points& x, const Points& v, int particle) {
    return -static_cast<double>(force_on(model, x, v, particle).dot(v.row(particle)));
}

double max_wind_power(const ClothModel& model) {
    constexpr double stretched = 2;
    const auto speed = static_cast<double>(model.air.velocity.norm());
    const Grid& grid = model.grid;
    const auto area = static_cast<double>(model.hx * model.hy) * (grid.nx - 1) * (grid.ny - 1);
    const auto pressure = static_cast<double>(plate_coefficient * model.air.density) / 2;  // divided by W^2
    return stretched * pressure * area * speed * speed * speed * 4 / 27;
}

}  // namespace drape
