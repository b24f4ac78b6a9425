#include "states.h"

#include <algorithm>
#include <cmath>
#include <random>

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

}  // namespace drape
