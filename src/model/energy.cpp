#include "drape/model/energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drape/base/vectorise.h"
#include "drape/model/forces.h"
#include "drape/model/stencils.h"
#include "wind.h"

namespace drape {
namespace {

/// Sums run in this many lanes, whatever the width of the vectors; element i goes to lane i modulo it.
constexpr int lanes = 8;

/// Springs are evaluated in runs of this many, so that what they give fits on the stack.
constexpr int run_length = 128;

using Lanes = std::array<double, lanes>;

double total(const Lanes& sums) {
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

/// @param values run_length of them, those from `count` on overwritten by zeros
DRAPE_INLINE void add_run(double* values, int count, Lanes& sums) {
    const int whole = (count + lanes - 1) / lanes * lanes;
    for (int i = count; i < whole; ++i) values[i] = 0;
    for (int i = 0; i < whole; i += lanes) {
        for (int lane = 0; lane < lanes; ++lane) sums[static_cast<std::size_t>(lane)] += values[i + lane];
    }
}

/// The sum of p^2.
DRAPE_VECTORISE double sum_of_squares(const Real* p, int count) {
    Lanes sums{};
    for (int start = 0; start < count; start += run_length) {
        const int length = std::min(run_length, count - start);
        double values[run_length];
        for (int i = 0; i < length; ++i) {
            const double value = static_cast<double>(p[start + i]);
            values[i] = value * value;
        }
        add_run(values, length, sums);
    }
    return total(sums);
}

struct Coordinates {
    const Real *x, *y, *z;
    explicit Coordinates(const Points& p) : x(p.col(0).data()), y(p.col(1).data()), z(p.col(2).data()) {}
};

/// Over the springs of one direction.
struct SpringSums {
    double squared_elongations = 0;     ///< of (|d| - L0)^2 [m^2]
    double squared_closing_speeds = 0;  ///< of (n.(v_a - v_b))^2; without a direction a spring adds nothing [m^2/s^2]
};

DRAPE_VECTORISE SpringSums sum_over_springs(const SpringStencil& stencil, const Grid& grid, const Points& x,
                                            const Points& v) {
    const Coordinates p(x), u(v);
    const auto rest = static_cast<double>(stencil.rest_length);
    const int count = stencil.count(grid);
    Lanes elongations{}, speeds{};
    for (int j = 0; j < stencil.rows(grid); ++j) {
        const int first = grid.particle(stencil.first_column(), j), reach = stencil.dj * grid.nx + stencil.di;
        for (int start = 0; start < count; start += run_length) {
            const int length = std::min(run_length, count - start);
            double elongation[run_length], speed[run_length];
            for (int i = 0; i < length; ++i) {
                const int a = first + start + i, b = a + reach;
                const double dx = p.x[a] - p.x[b], dy = p.y[a] - p.y[b], dz = p.z[a] - p.z[b];
                const double ux = u.x[a] - u.x[b], uy = u.y[a] - u.y[b], uz = u.z[a] - u.z[b];
                const double square = dx * dx + dy * dy + dz * dz, along = dx * ux + dy * uy + dz * uz;
                const double longer = std::sqrt(square) - rest;
                elongation[i] = longer * longer;
                speed[i] = along * along / std::max(square, std::numeric_limits<double>::min());
            }
            add_run(elongation, length, elongations);
            add_run(speed, length, speeds);
        }
    }
    return {total(elongations), total(speeds)};
}

double sum_of_squares(const Points& p) {
    const int count = static_cast<int>(p.rows());
    return sum_of_squares(p.col(0).data(), count) + sum_of_squares(p.col(1).data(), count) +
           sum_of_squares(p.col(2).data(), count);
}

/// @param power whose loss in springs and air is set on the way
Energy compute_energy(const ClothModel& model, const ClothState& state, Power& power) {
    const auto mass = static_cast<double>(model.particle_mass);
    const double squared_speeds = sum_of_squares(state.v);
    Energy energy;
    energy.kinetic = mass / 2 * squared_speeds;
    power.drag = static_cast<double>(model.drag) * squared_speeds;
    for (int axis = 0; axis < 3; ++axis) {
        const auto g = static_cast<double>(model.gravity[axis]);
        if (g != 0) energy.gravity -= mass * g * state.x.col(axis).cast<double>().sum();
    }
    for (const SpringStencil& stencil : spring_stencils(model)) {
        if (stencil.law == SpringLaw{}) continue;
        const SpringSums sums = sum_over_springs(stencil, model.grid, state.x, state.v);
        energy.spring += static_cast<double>(stencil.law.stiffness) / 2 * sums.squared_elongations;
        power.damping += static_cast<double>(stencil.law.damping) * sums.squared_closing_speeds;
    }
    return energy;
}

double dot(const Points& f, const Points& v, Eigen::Index particle) {
    return static_cast<double>(f.row(particle).dot(v.row(particle)));
}

}  // namespace

Energy compute_energy(const ClothModel& model, const ClothState& state) {
    Power power;
    return compute_energy(model, state, power);
}

EnergyFlow compute_energy_flow(const ClothModel& model, const ClothState& state, Points& scratch) {
    EnergyFlow flow;
    Power& power = flow.power;
    flow.energy = compute_energy(model, state, power);
    if (model.air.density > 0) {
        scratch.setZero();
        const Real* const x[3] = {state.x.col(0).data(), state.x.col(1).data(), state.x.col(2).data()};
        const Real* const v[3] = {state.v.col(0).data(), state.v.col(1).data(), state.v.col(2).data()};
        Real* const f[3] = {scratch.col(0).data(), scratch.col(1).data(), scratch.col(2).data()};
        kernels::wind_forces(model, x, v, f);
        for (Eigen::Index p = 0; p < scratch.rows(); ++p) power.wind += dot(scratch, state.v, p);
    }
    bool computed = false;
    for (Eigen::Index p = 0; p < state.v.rows(); ++p) {
        if (model.inverse_mass[p] != 0 || state.v.row(p).isZero(0)) continue;
        if (!computed) compute_forces(model, state.x, state.v, scratch);
        computed = true;
        power.hand -= dot(scratch, state.v, p);
    }
    return flow;
}

Real largest_stretch(const ClothModel& model, const Points& x) {
    Real largest = -1;
    const auto stencils = spring_stencils(model);
    for (const SpringStencil& stencil : {stencils[0], stencils[1]}) {
        for (int j = 0; j < stencil.rows(model.grid); ++j) {
            const int a = model.grid.particle(0, j), b = a + stencil.dj * model.grid.nx + stencil.di;
            for (int i = 0; i < stencil.count(model.grid); ++i) {
                largest = std::max(largest, (x.row(a + i) - x.row(b + i)).norm() / stencil.rest_length - 1);
            }
        }
    }
    return largest;
}

}  // namespace drape
