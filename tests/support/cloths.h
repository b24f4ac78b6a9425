#pragma once

#include <cmath>
#include <random>

#include "drape/model/cloth_model.h"

namespace drape::test {

/// A cloth in one of many shapes: flat, wavy, rolled or crumpled, by its seed.
/// @return n x 3 positions within about one metre of the origin
inline Points random_cloth(const Grid& grid, std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    const Real amplitude = Real(0.3) * std::abs(unit(random)), noise = Real(0.05) * std::abs(unit(random));
    const Real waves_i = 6 * unit(random), waves_j = 6 * unit(random), phase = 3 * unit(random);
    Points x(grid.particles(), 3);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const Real u = static_cast<Real>(i) / static_cast<Real>(grid.nx - 1) - Real(0.5);
            const Real w = static_cast<Real>(j) / static_cast<Real>(grid.ny - 1) - Real(0.5);
            x.row(grid.particle(i, j)) << u + noise * unit(random),
                amplitude * std::sin(waves_i * u + waves_j * w + phase) + noise * unit(random),
                w + noise * unit(random);
        }
    }
    return x;
}

/// A cloth of given size in a state that has nothing special about it: every spring stretched, every particle moving.
inline ClothState random_state(const ClothParameters& parameters, std::mt19937& random) {
    std::uniform_real_distribution<Real> unit(-1, 1);
    ClothState state = make_rest_state(parameters);
    const Real wobble = Real(0.2) * parameters.width / static_cast<Real>(parameters.particles.nx);
    for (Eigen::Index k = 0; k < state.x.size(); ++k) {
        state.x.data()[k] += wobble * unit(random);
        state.v.data()[k] = unit(random);
    }
    return state;
}

/// Columns and rows that fill no vector, and rows longer than a run of a kernel.
constexpr Grid odd_grids[] = {{2, 2}, {3, 3}, {2, 300}, {31, 17}, {129, 5}, {130, 4}, {257, 3}, {300, 2}};

/// All kinds of springs, each with a law of its own.
inline ClothParameters unlike_springs(const Grid& grid) {
    ClothParameters parameters;
    parameters.particles = grid;
    parameters.height = Real(1.7);
    parameters.structural = {900, Real(0.3)};
    parameters.shear = {400, Real(0.2)};
    parameters.bend = {70, Real(0.1)};
    return parameters;
}

}  // namespace drape::test
