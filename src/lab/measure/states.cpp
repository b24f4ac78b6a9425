#include "states.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "drape/base/exact_math.h"
#include "drape/model/energy.h"

namespace drape {

ClothState disturbed(const ClothModel& model, ClothState state) {
    std::mt19937 random(1);
    Points error = Points::Zero(state.x.rows(), 3);
    int free = 0;
    for (int p = 0; p < model.grid.particles(); ++p) {
        if (model.pinned(p)) continue;
        ++free;
        for (int axis = 0; axis < 3; ++axis) error(p, axis) = uniform<Real>(random);
    }
    state.x += error * (small_error * std::sqrt(static_cast<Real>(free)) / error.norm());
    return state;
}

Measure measure_for(double growth) { return growth <= most_growth ? Measure::Position : Measure::Overall; }

double position_error(const Points& x, const Points& exact, Real side) {
    const double squares = static_cast<double>((x - exact).squaredNorm());
    return std::sqrt(squares / static_cast<double>(x.rows())) / static_cast<double>(side);
}

double overall_error(const ClothModel& model, const ClothState& state, const ClothState& exact, Real side) {
    const Real sag = std::abs(state.x.col(1).minCoeff() - exact.x.col(1).minCoeff()) / side;
    const Real centre = (state.x - exact.x).colwise().mean().norm() / side;
    const auto energy_of = [&](const ClothState& one) { return compute_energy(model, one, Kernels::Vector).total(); };
    const double energy = std::abs(energy_of(state) - energy_of(exact));
    const Real mass = model.particle_mass * static_cast<Real>(model.grid.particles());
    return std::max({static_cast<double>(sag), static_cast<double>(centre),
                     energy / static_cast<double>(mass * model.gravity.norm() * side)});
}

double error_of(Measure measure, const ClothModel& model, const ClothState& state, const ClothState& exact, Real side) {
    return measure == Measure::Position ? position_error(state.x, exact.x, side)
                                        : overall_error(model, state, exact, side);
}

Points resampled(const Points& x, const Grid& from, const Grid& to) {
    if (from == to) return x;
    Points finer(to.particles(), 3);
    const auto cell_of = [](int k, int count, int cells) {
        const Real along = static_cast<Real>(k) * static_cast<Real>(cells) / static_cast<Real>(count - 1);
        const int cell = std::min(static_cast<int>(along), cells - 1);
        return std::pair(cell, along - static_cast<Real>(cell));
    };
    for (int j = 0; j < to.ny; ++j) {
        const auto [row, v] = cell_of(j, to.ny, from.cell_rows());
        for (int i = 0; i < to.nx; ++i) {
            const auto [column, u] = cell_of(i, to.nx, from.cell_columns());
            const int a = from.particle(column, row), c = from.particle(column, row + 1);
            finer.row(to.particle(i, j)) =
                (1 - v) * ((1 - u) * x.row(a) + u * x.row(a + 1)) + v * ((1 - u) * x.row(c) + u * x.row(c + 1));
        }
    }
    return finer;
}

}  // namespace drape
